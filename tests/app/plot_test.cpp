// carom plot: figures of a folder of results.

#include "app/program.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "figures.hpp"

namespace carom {
namespace {

using test::carom;
using test::Folder;
using testing::HasSubstr;

const std::string gas =
    "title = \"It's a gas\"\n[space]\nkind = \"periodic\"\nlower = [0, 0]\nupper = [20, 20]\n[[gas]]\ncount = 100\nradius = 0.5\n"
    "[run]\nevents = 4000\nsample_every = 0.5\n[observe]\nspeed_histogram = true\n"
    "[output]\nevents = \"events.csv\"\nledger = \"ledger.csv\"\n";

bool gnuplot_is_here() { return std::system("command -v gnuplot > /dev/null") == 0; }

TEST(Plot, draws_energy_collisions_and_speeds) {
  if (!gnuplot_is_here()) GTEST_SKIP() << "no gnuplot here";
  const Folder folder;
  folder.write("a.toml", gas);
  ASSERT_EQ(carom(folder, {"run", "a.toml", "--out", "r"}).status, 0);
  std::filesystem::copy_file(folder.file("r/ledger.csv"), folder.file("r/sine.csv"));
  folder.write("r/sine.csv", "# carom sine\nx,sin_x,error\n0,0,0.1\n1,0.84,0.1\n2,0.91,0.1\n");
  folder.write("r/notes.csv", "a,b\nnot,ours\n");
  const test::Outcome o = carom(folder, {"plot", "r"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.err, "");
  for (const char* name : {"energy", "collisions", "speeds", "sine"}) {
    EXPECT_THAT(o.out, HasSubstr("Wrote r/plots/" + std::string(name) + ".svg\n"));
    EXPECT_THAT(folder.read("r/plots/" + std::string(name) + ".svg"), HasSubstr("</svg>"));
  }
  EXPECT_THAT(folder.read("r/plots/speeds.svg"), HasSubstr("It's a gas"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("r/plots/notes.svg")));
  ASSERT_EQ(carom(folder, {"plot", "r", "--format", "png", "--out", "p"}).status, 0);
  EXPECT_EQ(folder.read("p/energy.png").substr(1, 3), "PNG");
}

// The block of data of a figure, as numbers.
std::vector<std::vector<double>> numbers_of(const app::Figure& figure) {
  std::vector<std::vector<double>> rows;
  const std::size_t from = figure.script.find('\n') + 1;
  for (const std::string& line : test::split(figure.script.substr(from, figure.script.find("EOD\n", from) - from), '\n')) {
    if (line.empty()) continue;
    rows.emplace_back();
    for (const std::string& word : test::split(line, ' ')) rows.back().push_back(std::stod(word));
  }
  return rows;
}

// In 2-D the speed has the density v/T exp(-v^2/2T), T = 2E/(2N). Both are densities, so their sums times the width are 1; the
// rates of 100 spans of time add up to the number of collisions.
TEST(Plot, data_are_densities_and_rates) {
  const Folder folder;
  folder.write("a.toml", gas);
  ASSERT_EQ(carom(folder, {"run", "a.toml", "--out", "r", "--set", "observe.speed_histogram=false", "--set",
                           "output.trajectory=\"t.csv\""})
                .status,
            0);
  const app::Figures figures = app::figures_in(folder.file("r"));
  ASSERT_EQ(figures.list.size(), 3U);
  EXPECT_TRUE(figures.missing.empty());
  for (const app::Figure& figure : figures.list) {
    const auto rows = numbers_of(figure);
    const double width = rows[1][0] - rows[0][0];
    double first = 0, second = 0;
    for (const auto& row : rows) {
      first += row[1] * width;
      second += row.size() > 2 ? row[2] * width : 0;
    }
    if (figure.name == "speeds") {
      EXPECT_NEAR(first, 1.0, 1e-12);
      EXPECT_NEAR(second, 1.0, 0.01);
    }
    if (figure.name == "collisions") {
      EXPECT_NEAR(first, 4000, 1e-6);
    }
  }
}

TEST(Plot, says_what_is_missing) {
  const Folder folder;
  std::filesystem::create_directory(folder.file("empty"));
  EXPECT_TRUE(app::figures_in(folder.file("empty")).list.empty());
  EXPECT_EQ(app::figures_in(folder.file("empty")).missing.size(), 3U);
  const test::Outcome o = carom(folder, {"plot", gnuplot_is_here() ? "empty" : "."});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr(gnuplot_is_here() ? "output.ledger" : "gnuplot-nox"));
  EXPECT_EQ(carom(folder, {"plot", "none"}).status, 2);
}

}  // namespace
}  // namespace carom
