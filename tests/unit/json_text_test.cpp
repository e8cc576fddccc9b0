#include "core/base/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/temporary_folder.h"
#include "unit/thread_time.h"

namespace dermis {
namespace {

using test::isOneSentence;
using test::threadSeconds;
using testing::HasSubstr;
using testing::StartsWith;

std::string refusal(std::string_view text) {
  const auto parsed = parseJson(text, "a.json");
  EXPECT_FALSE(parsed.has_value()) << text.substr(0, 80);
  if (parsed) return {};
  EXPECT_EQ(parsed.error().kind, Error::Kind::Input);
  EXPECT_TRUE(isOneSentence(parsed.error().message)) << parsed.error().message;
  EXPECT_TRUE(isUtf8(parsed.error().message));
  EXPECT_THAT(parsed.error().message, StartsWith("a.json"));
  return parsed.error().message;
}

TEST(ParseJson, SaysWhereItStopped) {
  EXPECT_THAT(refusal(""), HasSubstr("ends too early"));
  EXPECT_THAT(refusal("{\n  \"a\": 1,\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusal("{\n  \"a\": NaN}"), HasSubstr("line 2, column 8"));
  EXPECT_THAT(refusal("{\"a\": 1e999}"), HasSubstr("too large"));
  EXPECT_THAT(refusal("{\"a\": Infinity}"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("[1, 2"), HasSubstr("ends too early"));
  EXPECT_THAT(refusal("{} x"), HasSubstr("line 1, column 4"));
  EXPECT_THAT(refusal("{\"a\": 0,5}"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("{'a': 1}"), HasSubstr("line 1"));
}

TEST(ParseJson, RefusesInvalidUtf8) {
  EXPECT_THAT(refusal("{\"a\": \"\xff\"}"), HasSubstr("UTF-8"));
  refusal("{\"a\": \"\xc3\"}");
  refusal("{\"a\": \"\xed\xa0\x80\"}");
  refusal("{\"a\": \"\\ud800\"}");
  refusal(std::string(1000, '\xfe'));
}

TEST(ParseJson, RefusesAKeyThatStandsTwice) {
  EXPECT_THAT(refusal(R"({"a": {"b/c": [0, {"x": 1, "x": 2}]}})"), HasSubstr("/a/b~1c/1/x stands twice"));
}

TEST(ParseJson, RefusesDeepNestingWithoutRecursing) {
  const std::string deep = std::string(2000000, '[');
  EXPECT_THAT(refusal(deep), HasSubstr("nested deeper"));
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_THAT(refusal(objects), HasSubstr("nested deeper"));
  EXPECT_TRUE(parseJson(std::string(60, '[') + std::string(60, ']'), "a.json").has_value());
}

TEST(ParseJson, ManyKeysTakeNoQuadraticTime) {
  const auto seconds = [](std::size_t keys) {
    std::string text = "{\"k\": 0";
    for (std::size_t i = 0; i < keys; ++i) text += ",\"k" + std::to_string(i) + "\":0";
    text += "}";
    return threadSeconds([&] { EXPECT_EQ(parseJson(text, "a.json").value().size(), keys + 1); });
  };
  // 64 times as many keys: 64 to 200 times the time, whatever else the machine does, or 4,096 were it quadratic.
  const double few = seconds(3'125);
  EXPECT_LT(seconds(200'000), 800.0 * few);
}

TEST(WriteJson, ReadsAsTheDesignShowsIt) {
  const Json json = {{"name", "Fair, \"freckled\"\n"},
                     {"radius", Json::array({jsonNumber(3.67F), jsonNumber(1.37F), jsonNumber(0.68F)})},
                     {"map", {{"path", "a.png"}, {"invert", false}}},
                     {"rows", Json::array({Json::array({1, 2}), Json::array({3})})},
                     {"nested", {{"inner", {{"x", nullptr}}}}},
                     {"empty", Json::object()},
                     {"none", Json::array()}};
  EXPECT_EQ(writeJson(json),
            "{\n"
            "  \"name\": \"Fair, \\\"freckled\\\"\\n\",\n"
            "  \"radius\": [3.67, 1.37, 0.68],\n"
            "  \"map\": {\"path\": \"a.png\", \"invert\": false},\n"
            "  \"rows\": [[1, 2], [3]],\n"
            "  \"nested\": {\n"
            "    \"inner\": {\"x\": null}\n"
            "  },\n"
            "  \"empty\": {},\n"
            "  \"none\": []\n"
            "}\n");
}

TEST(WriteJson, ReadsBackTheSame) {
  const std::string text =
      R"({"big": 18446744073709551615, "least": -9223372036854775808, "x": 1e300, "tiny": 5e-324, "zero": -0.0, "u": "é\u0001\u007f😀"})";
  const Json once = parseJson(text, "a.json").value();
  const std::string written = writeJson(once);
  EXPECT_EQ(writeJson(parseJson(written, "a.json").value()), written);
  EXPECT_EQ(parseJson(written, "a.json").value(), once);
  EXPECT_THAT(written, HasSubstr("18446744073709551615"));
  EXPECT_THAT(written, HasSubstr("-0.0"));
}

TEST(WriteJson, StaysUtf8WhateverItIsGiven) {
  const std::string written = writeJson(Json("a\xff\xc3"));
  EXPECT_TRUE(isUtf8(written));
  EXPECT_TRUE(parseJson(written, "a.json").has_value());
}

TEST(JsonPointer, EscapesSteps) {
  EXPECT_EQ(pointerStep("/a", "b/c~d"), "/a/b~1c~0d");
  EXPECT_EQ(pointerStep("", 3), "/3");
  EXPECT_EQ(pointerStep("", "a\nb"), "/a\\nb");
}

TEST(InQuotes, CutsAndEscapes) {
  EXPECT_EQ(inQuotes("a\nb"), "\"a\\nb\"");
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "aä";
  EXPECT_TRUE(isUtf8(inQuotes(umlauts)));
  EXPECT_LT(inQuotes(umlauts).size(), 100U);
}

}  // namespace
}  // namespace dermis
