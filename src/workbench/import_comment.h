// What a scene has and OpenGL's calls cannot say (an n over 128, R·V, the name of a model), in a comment of the
// exported program, so that import gives the same scene. Each line says what import finds without it, too: where a
// student has changed that since, the line no longer holds.
#pragma once
#include <span>
#include <string>

#include "scene/scene.h"
#include "workbench/c_tokens.h"

namespace cg {

// The comment that turns `read` into `scene`; empty where they are alike.
std::string comment_between(const Scene& read, const Scene& scene);

// Changes `scene` as the comment among `comments`, if there is one, says.
void apply_comment(Scene& scene, std::span<const CComment> comments, Complaints& complaints);

}  // namespace cg
