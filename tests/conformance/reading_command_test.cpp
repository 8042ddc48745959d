// What people have, as the commands read it: the options that say how, what is left out and told, and what the oracle's
// program and `check` make of the same files (spec/formats/points.md).
#include <gtest/gtest.h>

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::reading_command_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

std::string input(const std::string& name) { return FLOWCERT_USER_INPUTS "/" + name; }

json json_of(const Words& words) {
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  json object = json::parse(finished.out, nullptr, false);
  EXPECT_TRUE(object.is_object()) << finished.out;
  return object.is_object() ? object : json::object();
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(Reading, RowsLeftOutAreToldAndListed) {
  CITES("FC-IN-01", "FC-IN-03", "FC-FILE-30");
  const Scratch scratch;
  const std::string file = input("nan_rows.ply");
  const Finished refused = flowcert({"compute", file});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("nan_rows.ply:11: not a finite number: 'nan'; --skip-invalid leaves such rows out"),
            std::string::npos)
      << refused.err;

  const Finished read = flowcert({"compute", file, "--skip-invalid", "-o", scratch.path("points.jsonl")});
  EXPECT_EQ(read.status, 0);
  EXPECT_NE(read.err.find("2 rows are left out"), std::string::npos) << read.err;
  EXPECT_NE(read.out.find("rows left out"), std::string::npos) << read.out;
  const json header = json::parse(first_line(content_of(scratch.path("points.jsonl"))));
  EXPECT_EQ(header["points"], 5);
  EXPECT_EQ(header["left_out"], json({3, 6}));
  for (const Words& command :
       {Words{"compute", file, "--json"}, Words{"persistence", file, "--json"}, Words{"pockets", file, "--json"},
        Words{"medial", file, "--json"}, Words{"orbit", file, "--from", "0.1,0.2,0.3", "--json"},
        Words{"surface", file, "-o", scratch.path("s.ply"), "--json"},
        Words{"check", file, scratch.path("points.jsonl"), "--json"}}) {
    Words words = command;
    words.emplace_back("--skip-invalid");
    EXPECT_EQ(json_of(words)["left_out"], json({3, 6})) << command[0];
  }
  EXPECT_NE(content_of(scratch.path("s.ply")).find(", rows left out: 2"), std::string::npos);
  ASSERT_EQ(flowcert({"persistence", file, "--skip-invalid", "-o", scratch.path("d.pers")}).status, 0);
  EXPECT_NE(content_of(scratch.path("d.pers")).find("# Rows of the file that were left out: 3 6\n"), std::string::npos);
  // Where none is left out, none is listed.
  EXPECT_FALSE(json_of({"compute", input("cloud.pcd"), "--skip-invalid", "--json"}).contains("left_out"));
}

TEST(Reading, ColumnsAndFrames) {
  CITES("FC-FILE-01", "FC-FILE-39", "FC-FILE-40");
  const Scratch scratch;
  const std::string table = scratch.file("a.txt", "1 0.5 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  const Finished refused = flowcert({"compute", table});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--columns 2,3,4"), std::string::npos) << refused.err;
  EXPECT_EQ(json_of({"compute", table, "--columns", "2,3,4", "--json"})["points"], 4);
  const std::string flat = scratch.file("flat.txt", "0 0\n1 0\n0 1\n");
  EXPECT_NE(flowcert({"compute", flat}).err.find("--z 0"), std::string::npos);
  EXPECT_EQ(json_of({"compute", flat, "--z", "0", "--json"})["points"], 3);
  const std::string frames = scratch.file("frames.xyz", "1\na\nC 0 0 0\n2\nb\nC 1 0 0\nC 2 0 0\n");
  EXPECT_EQ(json_of({"compute", frames, "--frame", "2", "--json"})["points"], 2);
  EXPECT_NE(flowcert({"compute", flat, "--frame", "2"}).err.find("--frame is for chemical XYZ, and this is table"),
            std::string::npos);
}

TEST(Reading, AtomsByWords) {
  const std::string file = input("ligand_and_water.pdb");
  const Finished all = flowcert({"pockets", file});
  EXPECT_NE(all.err.find("--atoms \"no ligands,no water\" leaves all of these out"), std::string::npos) << all.err;
  const json of_all = json_of({"pockets", file, "--persistence", "0", "--json"});
  const json of_protein = json_of({"pockets", file, "--persistence", "0", "--atoms", "protein", "--json"});
  EXPECT_EQ(of_all["points"], 34);
  EXPECT_EQ(of_protein["points"], 32);
  EXPECT_LT(of_protein["pockets"].size(), of_all["pockets"].size());
}

TEST(Reading, WithoutAValleyNothingIsCut) {
  const Scratch scratch;
  const json cap = json_of(
      {"surface", input("open_cap.xyz"), "--select", "index2-radius<auto", "-o", scratch.path("s.ply"), "--json"});
  EXPECT_EQ(cap["sets"], 699);
  EXPECT_EQ(cap["selected"], 699);
  const Finished table =
      flowcert({"surface", input("open_cap.xyz"), "--select", "index2-radius<auto", "-o", scratch.path("s.ply")});
  EXPECT_NE(table.out.find("valley of radii"), std::string::npos) << table.out;
  const std::string words = std::regex_replace(table.out, std::regex("\\s+"), " ");
  EXPECT_NE(words.find("none their histogram has one heap alone: all are taken"), std::string::npos) << table.out;
}

TEST(Reading, TheOracleGetsTheSamePointsOrRefuses) {
  CITES("FC-IN-03", "FC-IN-05");
  const Scratch scratch;
  for (const char* name : {"colmap_points3D.txt", "chemical.xyz", "leica.pts", "cloudcompare.asc", "cloud.pcd",
                           "glued_header.off", "nan_rows.ply", "serial_in_column_6.pdb", "qm9_methane.xyz"}) {
    const Finished finished = flowcert_oracle({"stationary", input(name)});
    EXPECT_EQ(finished.status, 2) << name;
    EXPECT_EQ(std::ranges::count(finished.err, '\n'), 1) << finished.err;
  }
  // The third column twice, so that z is another one than for the oracle.
  const std::string points = scratch.file("a.xyz", "0 0 0\n1 2 3\n3 1 2\n5 4 9\n"), records = scratch.path("r.jsonl");
  ASSERT_EQ(flowcert({"compute", points, "-o", records}).status, 0);
  EXPECT_EQ(flowcert_oracle({"certify", points, records}).status, 0);
  ASSERT_EQ(flowcert({"compute", points, "--columns", "3,1,2", "-o", records}).status, 0);
  const Finished other = flowcert_oracle({"certify", points, records});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE((other.out + other.err).find("is elsewhere in the input"), std::string::npos) << other.out << other.err;
}

// ---- Diagrams ----

// Its four points have a circle of three, and a sphere of all.
constexpr char kPoints[] = "0 0 0\n4 0 0\n0 4 1\n1 1 5\n";

TEST(CheckDiagrams, OfTextAndOfJson) {
  CITES("FC-CLAIM-11", "FC-FILE-28");
  const Scratch scratch;
  const std::string points = scratch.file("a.xyz", kPoints), diagram = scratch.path("d.pers");
  ASSERT_EQ(flowcert({"persistence", points, "-o", diagram}).status, 0);
  const std::string text = content_of(diagram);
  const std::string as_json = scratch.file("d.json", flowcert({"persistence", points, "--json"}).out);
  std::string with_field;
  for (const std::string& line : lines_of(text)) with_field += line.starts_with('#') ? "" : "11 " + line + "\n";
  const std::string gudhi = scratch.file("g.pers", with_field), unknown = scratch.file("g.txt", with_field);
  for (const std::string& claim : {diagram, scratch.file("d.txt", text), as_json, gudhi}) {
    const Finished finished = flowcert({"check", points, claim});
    EXPECT_EQ(finished.status, 0) << finished.out << finished.err;
    const json report = json_of({"check", points, claim, "--json"});
    EXPECT_EQ(report["verdict"], "conforms");
    EXPECT_EQ(report["claim_format"], "persistence");
    EXPECT_EQ(report["grade"], claim == as_json ? "exact" : "approximate");
    EXPECT_EQ(report["findings"], json::array());
    EXPECT_EQ(flowcert({"check", points, claim, "--oracle"}).status, 0);
  }
  const Finished asked = flowcert({"check", points, unknown});
  EXPECT_EQ(asked.status, 2);
  EXPECT_NE(asked.err.find("--claim-format pers"), std::string::npos) << asked.err;
  EXPECT_EQ(flowcert({"check", points, unknown, "--claim-format", "pers"}).status, 0);
}

TEST(CheckDiagrams, MissingAndSpuriousPairs) {
  CITES("FC-CLAIM-11", "FC-FILE-28");
  const Scratch scratch;
  const std::string points = scratch.file("a.xyz", "0 0 0\n2 0 0\n");
  // The true ones are 0 0 1 and 0 0 inf.
  const std::string claim = scratch.file("d.pers", "# mine\n0 0 inf\n0 0 3\n1 1 2\n");
  const Finished finished = flowcert({"check", points, claim, "--junit", scratch.path("report.xml")});
  EXPECT_EQ(finished.status, 1);
  const std::string out = unbroken(finished.out);
  EXPECT_NE(out.find("d.pers:3: wrong-pair [FC-CLAIM-11]: claimed dimension 0, birth 0, death 3; truth: dimension 0, "
                     "birth 0, death 1"),
            std::string::npos)
      << out;
  EXPECT_NE(out.find("d.pers:4: wrong-pair [FC-CLAIM-11]: claimed dimension 1, birth 1, death 2; truth: no such pair"),
            std::string::npos)
      << out;
  const json report = json::parse(flowcert({"check", points, claim, "--json"}).out);
  EXPECT_EQ(report["verdict"], "fails");
  EXPECT_EQ(report["pairs"][0], json({{"dimension", 0}, {"claimed", 2}, {"true", 2}, {"spurious", 1}, {"missing", 1}}));
  EXPECT_EQ(report["pairs"][1], json({{"dimension", 1}, {"claimed", 1}, {"true", 0}, {"spurious", 1}, {"missing", 0}}));
  EXPECT_EQ(report["findings"].size(), 2U);
  EXPECT_EQ(report["findings"][1]["line"], 4);
  EXPECT_TRUE(report["findings"][1]["truth"].is_null());
  EXPECT_NE(content_of(scratch.path("report.xml")).find("failures=\"1\""), std::string::npos);
  EXPECT_EQ(flowcert({"check", points, claim, "--highest-level", "2"}).status, 2);
}

}  // namespace
}  // namespace flowcert::conformance::reading_command_test
