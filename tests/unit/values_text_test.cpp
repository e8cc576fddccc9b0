// Values to a text and back, for the clipboard.
#include "core/material/values_text.h"

#include <gtest/gtest.h>

#include "core/material/preset_io.h"

namespace dermis {
namespace {

TEST(ValuesText, EveryParameterComesBack) {
  MaterialParameters parameters;
  parameters.specularF0 = Colour{{0.03F, 0.04F, 0.05F}};
  parameters.subsurfaceProfile = DiffusionFamily::Gaussians;
  parameters.specularIor = 1.4234567F;
  std::vector<NamedValue> values;
  for (const ParameterRow& row : parameterTable()) values.push_back({&row, row.get(parameters)});
  const auto read = readValues(writeValues(values));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ((*read)[i].row, values[i].row);
    EXPECT_EQ((*read)[i].value, values[i].value) << values[i].row->id;
  }
}

TEST(ValuesText, ARowFindsItsOwnValueInAPreset) {
  Material material;
  material.parameters.specularLobeMix = 0.3125F;
  const std::string preset = writePreset(material, {});
  EXPECT_EQ(*readValueFor(*findParameter("specular.lobe_mix"), preset), ParameterValue(0.3125F));
}

TEST(ValuesText, ARowTakesTheOnlyValueOfItsType) {
  const ParameterRow& lobes = *findParameter("specular.lobe_mix");
  const ParameterRow& weight = *findParameter("subsurface.weight");
  const ParameterRow& albedo = *findParameter("base.albedo");
  const std::string one = writeValues({{&lobes, ParameterValue(0.25F)}});
  EXPECT_EQ(*readValueFor(weight, one), ParameterValue(0.25F));
  const std::string two = writeValues({{&lobes, ParameterValue(0.25F)}, {&albedo, albedo.defaultValue()}});
  EXPECT_FALSE(readValueFor(weight, two));
  EXPECT_FALSE(readValueFor(*findParameter("specular.lobe_scale"), one));
}

TEST(ValuesText, JunkIsOneSentence) {
  for (const char* junk : {"", "hello", "{", "[]", "{}", R"({"format": "dermis.values"})",
                           R"({"format": "dermis.values", "version": 2, "values": {"specular.ior": 1}})",
                           R"({"format": "dermis.values", "version": 1, "values": {"specular.ior": "a"}})",
                           R"({"format": "dermis.values", "version": 1, "values": []})"}) {
    const auto read = readValues(junk);
    ASSERT_FALSE(read) << junk;
    EXPECT_EQ(read.error().kind, Error::Kind::Input);
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
    EXPECT_FALSE(readValueFor(*findParameter("specular.ior"), junk)) << junk;
  }
}

}  // namespace
}  // namespace dermis
