#include "scene/named_materials.h"

#include <gtest/gtest.h>

#include <set>

using namespace cg;

TEST(NamedMaterials, are_24_with_names_of_their_own_in_both_languages) {
  std::set<std::string_view> ids, english, japanese;
  for (const NamedMaterial& m : named_materials)
    ids.insert(m.id), english.insert(m.label.en), japanese.insert(m.label.ja);
  EXPECT_EQ(named_materials.size(), 24u);
  EXPECT_EQ(ids.size(), 24u);
  EXPECT_EQ(english.size(), 24u);
  EXPECT_EQ(japanese.size(), 24u);
}

TEST(NamedMaterials, are_what_a_material_and_opengl_accept) {
  for (const NamedMaterial& named : named_materials) {
    const Material m = with(Material{}, named);
    std::apply(
        [&](const auto&... f) {
          const auto check = [&](const auto& field) {
            const auto& value = m.*field.member;
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
              EXPECT_TRUE(field.about.accepts(value)) << named.id;
            } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, glm::dvec3>) {
              for (int i = 0; i < 3; ++i) EXPECT_TRUE(field.about.accepts(value[i])) << named.id;
            }
          };
          (check(f), ...);
        },
        fields_of<Material>);
    EXPECT_LE(m.n, 128) << named.id;
    EXPECT_GE(m.n, 10) << named.id;
    // A material of that time: what it scatters of the ambient light it scatters of the others, or more.
    for (int i = 0; i < 3; ++i) EXPECT_LE(m.k_a[i], m.k_d[i] + 0.0101) << named.id;
  }
}

TEST(NamedMaterials, change_the_terms_of_the_light_model_only) {
  Material m;
  m.k_r = {0.1, 0.2, 0.3}, m.emission = {1, 0, 0};
  const Material brass = with(m, named_materials[6]);
  EXPECT_EQ(named_materials[6].id, "brass");
  EXPECT_EQ(brass.k_r, m.k_r);
  EXPECT_EQ(brass.emission, m.emission);
  EXPECT_EQ(brass.k_d, glm::dvec3(0.780392, 0.568627, 0.113725));
  EXPECT_NEAR(brass.n, 27.8974, 1e-4);
}
