#include "mapping/unwrap.h"

#include <cmath>

#include "mapping/automatic_seams.h"
#include "mapping/cut_to_disk.h"
#include "mapping/pack.h"
#include "mapping/parallel.h"
#include "params/input_error.h"

namespace cg {

namespace {

// Laid flat by the method; by another one where that lies no worse and this one flips or overlaps, if `mend`.
FlatChart laid(const ChartMesh& mesh, UnwrapMethod method, bool mend) {
  FlatChart out = flatten(mesh, method);
  if (!mend || out.injective()) return out;
  for (const UnwrapMethod other :
       {UnwrapMethod::spectral, UnwrapMethod::lscm, UnwrapMethod::free_boundary, UnwrapMethod::mean_value}) {
    if (other == method) continue;
    FlatChart next = flatten(mesh, other);
    if (next.injective()) return next;
  }
  return out;
}

// Faces without area lie where their vertices do in one of the others' charts.
void place_degenerate_faces(const UnwrapSurface& s, CornerUv& uv) {
  std::vector<std::uint32_t> some(s.mesh().data().positions.size(), no_index);
  for (std::uint32_t c = 0; c < uv.size(); ++c)
    if (s.has_area(s.face_of(c))) some[s.position_of(c)] = c;
  for (std::uint32_t c = 0; c < uv.size(); ++c)
    if (!s.has_area(s.face_of(c)) && some[s.position_of(c)] != no_index) uv[c] = uv[some[s.position_of(c)]];
}

double share_of_margin(const Unwrapping& options) { return options.margin / double(options.texture_size); }

}  // namespace

UvLayout unwrap(const MeshHandle& mesh, const Unwrapping& options, const std::string& where) {
  const UnwrapSurface surface(mesh, where);
  EdgeCuts cuts = border_cuts(surface);
  cut_seams(surface, options.seams, cuts);
  if (options.automatic_seams) cut_automatically(surface, options, cuts);
  ChartFaces charts = charts_between(surface, cuts);
  if (charts.faces.empty())
    throw InputError(where, {"the mesh has no face with an area", "面積のある面がない"},
                     {"an unwrap needs at least one", "展開には一つ以上必要"});
  std::vector<std::uint32_t> vertex_of(surface.corner_count());
  std::vector<ChartMesh> meshes(charts.faces.size());
  std::vector<FlatPiece> pieces(charts.faces.size());
  in_parallel(charts.faces.size(), [&](std::size_t i) {
    cut_to_disk(surface, charts.faces[i], cuts, vertex_of);
    meshes[i] = make_chart_mesh(surface, cuts, charts.faces[i], vertex_of);
    pieces[i] = {laid(meshes[i], options.method, options.automatic_seams).flat, meshes[i].triangle};
  });
  pack(pieces, share_of_margin(options));
  UvLayout out{mesh, CornerUv(surface.corner_count(), glm::dvec2(0)), std::move(charts.chart_of),
               std::uint32_t(charts.faces.size())};
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < meshes[i].corner.size(); ++k)
      out.uv[meshes[i].corner[k]] = pieces[i].flat[meshes[i].vertex[k]];
  place_degenerate_faces(surface, out.uv);
  return out;
}

UvLayout pack_again(const UvLayout& layout, const Unwrapping& options) {
  UvLayout out = layout;
  std::vector<FlatPiece> pieces(layout.charts);
  std::vector<std::vector<std::uint32_t>> corners(layout.charts);
  std::vector<DistortionSum> sums(layout.charts);
  const std::vector<Stretch> stretches = stretches_of(layout);
  for (std::size_t t = 0; t < stretches.size(); ++t) {
    const Triangle& triangle = layout.mesh->triangles()[t];
    const std::uint32_t chart = layout.chart[triangle.face];
    const std::uint32_t n = std::uint32_t(pieces[chart].flat.size());
    sums[chart].add(stretches[t]);
    pieces[chart].triangle.push_back({n, n + 1, n + 2});
    for (const std::uint32_t c : triangle.corner)
      pieces[chart].flat.push_back(layout.uv[c]), corners[chart].push_back(c);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (sums[i].flat_area > 0)
      for (glm::dvec2& p : pieces[i].flat) p *= std::sqrt(sums[i].surface_area / sums[i].flat_area);
  pack(pieces, share_of_margin(options));
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < corners[i].size(); ++k) out.uv[corners[i][k]] = pieces[i].flat[k];
  return out;
}

}  // namespace cg
