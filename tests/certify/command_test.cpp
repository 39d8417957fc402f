// carom certify, as a program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "certify/scenes.hpp"

namespace carom {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using test::carom;
using test::Folder;

TEST(CertifyCommand, writes_a_certificate_that_it_verifies) {
  const Folder folder;
  folder.write("photon.toml", testing::photon);
  const test::Outcome o = carom(folder, {"certify", "photon.toml", "--out", "proof"});
  ASSERT_EQ(o.status, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("14 events"));
  const test::Csv table(folder.read("proof/certified.csv"));
  EXPECT_TRUE(table.whole);
  ASSERT_EQ(table.rows.size(), 14u);
  EXPECT_LT(std::stod(table.rows[0].at("lower")), std::stod(table.rows[13].at("upper")));
  for (const std::vector<std::string>& words : {std::vector<std::string>{"certify", "--verify", "proof/certified.csv"},
                                                {"certify", "--verify", "proof/certified.csv", "photon.toml"}}) {
    const test::Outcome verified = carom(folder, words);
    EXPECT_EQ(verified.status, 0) << verified.err;
    EXPECT_THAT(verified.out, HasSubstr("verified        14 events"));
  }
}

TEST(CertifyCommand, prints_one_json_object) {
  const Folder folder;
  folder.write("photon.toml", testing::photon);
  const json j = json::parse(carom(folder, {"certify", "photon.toml", "--json", "--digits", "130"}).out);
  EXPECT_EQ(j["verdict"], "proven");
  EXPECT_EQ(j["events"], 14);
  EXPECT_EQ(j["digits"], 130);
  EXPECT_EQ(j["against_double"]["compared"], 14);
  EXPECT_TRUE(j["against_double"]["different"].is_null());
  EXPECT_EQ(j["final"].size(), 2u);
  EXPECT_THAT(j["final"][0]["position"][0]["lower"].get<std::string>(), HasSubstr("-0.736292698609618310775737171"));
}

TEST(CertifyCommand, says_what_is_undecided_or_wrong) {
  const Folder folder;
  folder.write("tie.toml", "[[ball]]\nposition = [-3, 0]\nvelocity = [1, 0]\n[[ball]]\nposition = [0, 0.55]\n[[ball]]\nposition = [0, -0.55]\n[run]\nuntil = 9\n");
  const test::Outcome tie = carom(folder, {"certify", "tie.toml"});
  EXPECT_EQ(tie.status, 3);
  EXPECT_THAT(tie.err, HasSubstr("event 1: ball 0 and ball 1 meet at the moment at which ball 0 and ball 2 do: a tie"));

  folder.write("photon.toml", testing::photon);
  ASSERT_EQ(carom(folder, {"certify", "photon.toml"}).status, 0);
  std::string certificate = folder.read("certified.csv");
  certificate.replace(certificate.find("# end 10"), 8, "# end 20");
  folder.write("wrong.csv", certificate);
  const test::Outcome wrong = carom(folder, {"certify", "--verify", "wrong.csv"});
  EXPECT_EQ(wrong.status, 3);
  EXPECT_THAT(wrong.err, HasSubstr("event 15: ball 0 and ball 1 overlap"));

  EXPECT_EQ(carom(folder, {"certify"}).status, 2);
  EXPECT_EQ(carom(folder, {"certify", "--verify", "nothing.csv"}).status, 2);
  EXPECT_EQ(carom(folder, {"certify", "--verify", "photon.toml"}).status, 2);
  folder.write("stick.toml", "[collision]\nlaw = \"stick\"\n" + std::string(testing::photon));
  EXPECT_EQ(carom(folder, {"certify", "stick.toml"}).status, 2);
}

}  // namespace
}  // namespace carom
