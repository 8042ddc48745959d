// `flowcert conformance` as a user calls it: the verdict on our own program, the choice of cases, reports,
// and what is kept (spec/formats/conformance.md).
//
// Guarantees: our own program is right on every fourth case, and on every one in a whole run (./dev test --slow).
// Vectors that cannot be used are refused.
#include <expat.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "tests/cites.h"
#include "tests/conformance/conformance_fixture.h"
#include "tests/run_scale.h"

namespace flowcert::conformance::conformance_command_test {
namespace {

constexpr std::size_t kStep = 4;

// Every fourth case of the vectors, or all of them.
class ManyVectors {
 public:
  ManyVectors() {
    for (const auto& entry : fs::directory_iterator(FLOWCERT_VECTORS)) {
      if (entry.is_directory()) continue;  // balls/
      json file = json::parse(content_of(entry.path().string()));
      if (file.contains("cases") && !flowcert_tests::is_whole_run()) {
        json cases = json::array();
        for (std::size_t k = 0; k < file["cases"].size(); k += kStep) cases.push_back(file["cases"][k]);
        file["cases"] = cases;
      }
      std::ofstream(scratch_.path(entry.path().filename().string())) << file;
    }
  }
  [[nodiscard]] std::string folder() const { return scratch_.path(""); }

 private:
  Scratch scratch_;
};

std::vector<json> cases_in(const std::string& folder) {
  std::vector<json> cases;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) continue;  // balls/
    const json file = json::parse(content_of(entry.path().string()));
    if (!file.contains("cases")) continue;
    for (const json& one : file["cases"]) cases.push_back(one);
  }
  return cases;
}

// A claim for the right triangle that has an edge and a facet at one place.
constexpr char kPerturbedTriangle[] =
    "printf '0,0,0,0\\n0,3,0,0\\n0,0,4,0\\n1,1.5,0,0\\n1,0,2,0\\n1,1.5,2,0,,1,2\\n2,1.5,2,0,,0,1,2\\n' > "
    "$2";

// ---- Programs that are right

TEST_F(ConformanceCommand, OurOwnProgramIsRightOnAllCases) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-03", "FC-IN-04", "FC-IN-05", "FC-CRIT-02", "FC-CRIT-03", "FC-OUT-01",
        "FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07", "FC-CLAIM-06", "FC-FILE-26", "FC-FILE-27", "FC-FILE-28");
  const ManyVectors vectors;
  const std::vector<json> cases = cases_in(vectors.folder());
  std::size_t orbits = 0, with_pairs = 0;
  std::map<std::string, std::size_t> flags;
  for (const json& one : cases) {
    for (const json& flag : one["flags"]) ++flags[flag];
    if (one.contains("expected")) with_pairs += one["expected"].contains("persistence") ? 1 : 0;
    if (one.contains("expected")) orbits += one["expected"].value("orbits", json::array()).size();
  }
  const json report = as_json({"--against", kCompute, "--orbits-against", kOrbit, "--persistence-against", kPersistence,
                               "--jobs", "2", "--time-limit", "120"},
                              vectors.folder());
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["profile"]["parts"], json({"points", "U2", "orbits", "persistence"}));
  EXPECT_EQ(report["profile"]["grade"], "approximate") << "pairs in decimals";
  ASSERT_EQ(report["cases"].size(), cases.size());
  for (const json& one : report["cases"]) {
    const bool is_invalid = one["group"] == "invalid-input";
    EXPECT_EQ(one["outcome"], is_invalid ? "properly refused" : "conforms") << one;
    EXPECT_EQ(one["message"].get<std::string>().starts_with("exit status 2: flowcert: "), is_invalid) << one;
    EXPECT_EQ(one["findings"], json::array());
  }
  EXPECT_EQ(report["judged"]["orbits"], orbits);
  EXPECT_EQ(report["judged"]["persistence"], with_pairs);
  EXPECT_GE(with_pairs, 60U / kStep);
  EXPECT_GT(report["judged"]["4"], cases.size() / 2);
  EXPECT_EQ(report["flags"].size(), flags.size());
  for (const json& flag : report["flags"]) {
    EXPECT_EQ(flag["cases"], flags[flag["flag"]]);
    EXPECT_EQ(flag["conforms"], flag["cases"]);
  }
}

TEST_F(ConformanceCommand, AsksForTheWholeComplex) {
  CITES("FC-UNST-02", "FC-CONN-01", "FC-VOL-01", "FC-CLAIM-13", "FC-CLAIM-14", "FC-CLAIM-15", "FC-CLAIM-16");
  const std::string compute = std::string(FLOWCERT_PROGRAM) + " compute {in} -o {out} --manifolds all --volumes exact";
  const Words groups = {"--group", "lambda-lists", "--group", "connections", "--group", "volumes", "--jobs", "2"};
  const ManyVectors vectors;
  const auto report_of = [&](const std::string& command, Words words, const std::string& folder = FLOWCERT_VECTORS) {
    words.insert(words.begin(), {"--against", command, "--time-limit", "120"});
    return as_json(words, folder);
  };
  const json report = report_of(compute, groups, vectors.folder());
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["judged"]["5"], report["cases"].size());
  EXPECT_GE(report["cases"].size(), 120U / kStep);
  const std::string with_sheets = compute + " --sheets";
  const json sheets = report_of(with_sheets, {"--group", "unstable-surfaces", "--jobs", "2"}, vectors.folder());
  EXPECT_EQ(sheets["verdict"], "conforms");
  EXPECT_EQ(sheets["judged"]["5"], sheets["cases"].size());
  EXPECT_GE(sheets["cases"].size(), 40U / kStep);
  const auto reason_of = [&](const std::string& edit, const std::string& id) {
    return report_of(with_sheets + " && sed -i -E '" + edit + "' {out}", {"--case", id})["reasons"][0]["reason"];
  };
  EXPECT_EQ(reason_of(R"(s/"families":1/"families":2/)", "connections-0012"), "wrong-connections");
  EXPECT_EQ(reason_of(R"(s/"volume":"4\/3"/"volume":"5\/3"/)", "volumes-0013"), "wrong-volume");
  EXPECT_EQ(reason_of(R"(s/"arcs":\[null/"arcs":[[0]/)", "lambda-lists-0012"), "wrong-lambda-list");
  EXPECT_EQ(reason_of(R"(s/"runs":\[\]/"runs":[{"polygon":[0,1,2,3],"from":[0,0,0],"to":[1,1,1]}]/)",
                      "unstable-surfaces-0012"),
            "wrong-unstable-set");
}

TEST_F(ConformanceCommand, GivesThePointsInOtherForms) {
  CITES("FC-IN-02", "FC-IN-04");
  const Words magnitudes = {"--group", "magnitudes", "--flag", "subnormal", "--flag", "near-overflow"};
  const auto verdict = [&](Words words) {
    words.insert(words.end(), magnitudes.begin(), magnitudes.end());
    return as_json(words, FLOWCERT_VECTORS)["verdict"];
  };
  EXPECT_EQ(verdict({"--against", kCompute}), "conforms");
  EXPECT_EQ(verdict({"--against", kCompute, "--hex"}), "conforms");
  EXPECT_EQ(verdict({"--against", kCompute, "--in-format", "off"}), "conforms");

  const std::string seen = scratch_.path("seen");
  const std::string look = "cat {in} > " + seen + "; exit 1";
  EXPECT_EQ(run({"--against", look, "--case", kTetrahedron}).status, 1);
  EXPECT_EQ(content_of(seen), "0 0 0\n1 1 0\n1 0 1\n0 1 1\n");
  EXPECT_EQ(run({"--against", look, "--case", kTetrahedron, "--in-format", "off", "--hex"}).status, 1);
  EXPECT_TRUE(content_of(seen).starts_with("OFF\n4 0 0\n0x0p+0 0x0p+0 0x0p+0\n0x1p+0 ")) << content_of(seen);
  // A file of an invalid case has the case's own fault and no other.
  EXPECT_EQ(run({"--against", look, "--case", "invalid-input-0007"}).status, 0);
  EXPECT_EQ(content_of(seen), "0 0 0\n1 1e309 0\n0 2 0\n");
  // This case is about the text of an XYZ file.
  const Finished no_text = run({"--against", look, "--case", "invalid-input-0027", "--in-format", "off"});
  EXPECT_EQ(no_text.status, 2);
  EXPECT_NE(no_text.err.find("invalid-input-0027 is about the text of an XYZ file"), std::string::npos) << no_text.err;
}

TEST_F(ConformanceCommand, TakesClaimsInAnyFormatFromWhereverTheyAre) {
  CITES("FC-CLAIM-04", "FC-CLAIM-05", "FC-FILE-12");
  const std::string by_file = std::string(FLOWCERT_PROGRAM) + " compute {in} -o points.jsonl > /dev/null; ";
  EXPECT_EQ(run({"--against", by_file + "cat points.jsonl", "--case", kTetrahedron}).status, 0) << "standard output";
  EXPECT_EQ(run({"--against", by_file + "cp points.jsonl \"my claim's\"", "--case", kTetrahedron}).status, 1);
  EXPECT_EQ(run({"--against", by_file + "cp points.jsonl \"my claim's\"; test {out} -ef \"my claim's\"", "--out-name",
                 "my claim's", "--case", kTetrahedron})
                .status,
            0);
  // This claim is that of a perturbation.
  const json one = outcome_of(kPerturbedTriangle, "regular-stationary-points-0001");
  EXPECT_EQ(one["outcome"], "perturbed") << one;
  EXPECT_NE(one["message"].get<std::string>().find("symbolic-perturbation [FC-CLAIM-04]"), std::string::npos);
}

// ---- Choosing, reports, what is kept

// The cases that --list prints. A case begins two blanks from the left, and what goes on is indented more.
Words listed_cases(const std::string& list) {
  Words cases;
  for (const std::string& line : lines_of(list)) {
    EXPECT_TRUE(line.starts_with("  "));
    if (line.starts_with("   ")) {
      cases.back() += line;
    } else {
      cases.push_back(line);
    }
  }
  return cases;
}

TEST_F(ConformanceCommand, ChoosesCases) {
  CITES("FC-IN-04");
  const auto listed = [](Words words) {
    words.emplace_back("--list");
    const Finished finished = run(words, FLOWCERT_VECTORS);
    EXPECT_EQ(finished.status, 0) << finished.err;
    return listed_cases(finished.out);
  };
  EXPECT_EQ(listed({}).size(), cases_in(FLOWCERT_VECTORS).size());
  const auto collinear = listed({"--flag", "collinear"});
  EXPECT_GT(collinear.size(), 2U);
  for (const std::string& line : collinear) EXPECT_NE(line.find("collinear"), std::string::npos) << line;
  for (const std::string& line : listed({"--group", "orbits", "--flag", "collinear"})) {
    EXPECT_TRUE(line.starts_with("  orbits-")) << line;
  }
  EXPECT_EQ(listed({"--case", kTetrahedron, "--case", kTriangleOrbits}).size(), 2U);
  const auto refuses = [](const Words& words, const std::string& what) {
    const Finished finished = run(words);
    EXPECT_EQ(finished.status, 2) << finished.out;
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
  };
  refuses({"--list", "--flag", "no-flag"}, "there is no flag 'no-flag'; there are: ");
  refuses({"--list", "--flag", "colinear"}, "there is no flag 'colinear'; there are: collinear, ");
  refuses({"--list", "--flag", "colinear"}, ", and others, which --list shows\n");
  refuses({"--list", "--group", "no-group"}, "there is no group 'no-group'; there are: ");
  refuses({"--list", "--group", "stable-manifold"},
          "there is no group 'stable-manifold'; there are: unstable-manifolds, ");
  const Finished degenerate = flowcert({"conformance", "--list", "--group", "degenerate"});
  EXPECT_EQ(lines_of(degenerate.err).size(), 1U) << degenerate.err;
  for (const auto& entry : fs::directory_iterator(FLOWCERT_VECTORS)) {
    if (entry.is_directory()) continue;  // balls/
    const std::string group = entry.path().stem().string();
    EXPECT_EQ(degenerate.err.find(group) != std::string::npos, group != "flags") << group << degenerate.err;
  }
  refuses({"--list", "--case", "orbits-9999"}, "there is no case 'orbits-9999'");
  refuses({"--list", "--case", kTetrahedron, "--group", "orbits"}, "no case is in all of");
  refuses({}, "--against");
  refuses({"--against", "true"}, "{in}");
  refuses({"--against", "true {in}", "--orbits-against", "true {in}"}, "{start}");
  refuses({"--against", "true {in}", "--persistence-against", "true"}, "{in}");
  refuses({"--against", "true {in}", "--time-limit", "nan"}, "--time-limit");
  refuses({"--against", "true {in}", "--out-name", "../claim"}, "--out-name");
  refuses({"--against", "true {in}", "--junit", scratch_.path("none/report.xml")}, "none/report.xml");
}

TEST_F(ConformanceCommand, RefusesVectorsThatItCannotUse) {
  CITES("FC-IN-05");
  const std::string folder = scratch_.path("vectors");
  const auto refuses = [&](const std::string& name, const std::string& content, const std::string& what) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    for (const char* file : {"flags.json", "duplicates.json"}) {
      fs::copy_file(fs::path(FLOWCERT_VECTORS) / file, fs::path(folder) / file);
    }
    EXPECT_EQ(flowcert({"conformance", "--vectors", folder, "--list"}).status, 0);
    std::ofstream(folder + "/" + name) << content;
    const Finished finished = flowcert({"conformance", "--vectors", folder, "--list"});
    EXPECT_EQ(finished.status, 2) << finished.out;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
  };
  const json whole = json::parse(content_of(std::string(FLOWCERT_VECTORS) + "/duplicates.json"));
  const auto damaged = [&](const std::string& pointer, const json& value) {
    json file = whole;
    file[json::json_pointer(pointer)] = value;
    return file.dump();
  };
  const std::string name = "duplicates.json";
  refuses(name, whole.dump().substr(0, 1000), name);
  refuses(name, damaged("/format_version", 2), "version 1");
  refuses(name, damaged("/cases/0/flags/0", "unheard-of"), "'unheard-of'");
  refuses(name, damaged("/cases/1/id", whole["cases"][0]["id"]), "two cases");
  refuses(name, damaged("/cases/0/id", "../somewhere"), "case 1");
  refuses(name, damaged("/cases/2/points/0/0", "one"), "case 3");
  refuses(name, damaged("/cases/0/expected/stationary/0/contact", {1000000}), "case 1");
  refuses(name, damaged("/cases/0/expected/stationary/0/center/0", "1/0"), "case 1");
  refuses(name, damaged("/cases/0/result", "unknown"), "'unknown'");
  json turned = whole;
  std::reverse(turned["cases"][3]["expected"]["stationary"].begin(),
               turned["cases"][3]["expected"]["stationary"].end());
  refuses(name, turned.dump(), "not in order");
  refuses("flags.json", "{}", "flags.json");
  const auto damaged_other = [](const std::string& group, const std::string& id, const std::string& pointer,
                                const json& value) {
    json file = json::parse(content_of(std::string(FLOWCERT_VECTORS) + "/" + group + ".json"));
    std::erase_if(file["cases"].get_ref<json::array_t&>(), [&](const json& one) { return one["id"] != id; });
    file[json::json_pointer("/cases/0/expected/" + pointer)] = value;
    return file.dump();
  };
  const auto refuses_pairs = [&](const std::string& pointer, const json& value, const std::string& what) {
    refuses("persistence.json", damaged_other("persistence", kTrianglePairs, pointer, value), what);
  };
  refuses_pairs("persistence/0/dimension", 3, "'dimension'");
  refuses_pairs("persistence/0/birth", "1/0", "no rational");
  refuses_pairs("persistence/3/death", "9/2", "of no length");
  refuses_pairs("persistence/0/death", "100", "not in order");
  refuses_pairs("persistence", 5, "no array");
  const auto refuses_stable = [&](const std::string& pointer, const json& value, const std::string& what) {
    refuses("stable-manifolds.json",
            damaged_other("stable-manifolds", "stable-manifolds-0005", "stationary/6/stable/" + pointer, value), what);
  };
  refuses_stable("segments", "three", "case 1");
  refuses_stable("boundary/0", {0, 1, 2}, "a boundary with what");
  refuses_stable("boundary/0", {0, 9}, "none of the points");
  refuses_stable("boundary/0", {1, 2}, "a boundary that is not in order");
  refuses_stable("walk/0", 3, "a walk along");
  EXPECT_EQ(flowcert({"conformance", "--vectors", scratch_.path("none"), "--list"}).status, 2);
}

TEST_F(ConformanceCommand, FindsTheVectorsThatAreInstalledWithIt) {
  CITES("FC-IN-04");
  const fs::path prefix = scratch_.path("prefix");
  fs::create_directories(prefix / "bin");
  fs::copy_file(FLOWCERT_PROGRAM, prefix / "bin" / "flowcert");
  const Words list = {(prefix / "bin" / "flowcert").string(), "conformance", "--list"};
  EXPECT_EQ(listed_cases(RunningProgram(list).finish().out).size(), cases_in(FLOWCERT_VECTORS).size())
      << "the source tree's";
  const fs::path vectors = prefix / "share" / "flowcert" / "vectors";
  fs::create_directories(vectors);
  for (const char* file : {"flags.json", "invalid-input.json"}) {
    fs::copy_file(fs::path(FLOWCERT_VECTORS) / file, vectors / file);
  }
  for (const std::string& line : listed_cases(RunningProgram(list).finish().out)) {
    EXPECT_TRUE(line.starts_with("  invalid-input-")) << line;
  }
}

TEST_F(ConformanceCommand, PrintsATable) {
  CITES("FC-CLAIM-03");
  const std::string no =
      script("test $(wc -l < \"$1\") -gt 3 || exit 1\n" + std::string(FLOWCERT_PROGRAM) + " compute \"$1\" -o \"$2\"");
  const Words words = {"--against",     no,       "--case",           "flat-inputs-0003", "--case",
                       kTriangleOrbits, "--case", "flat-inputs-0005", "--case",           kTetrahedron,
                       "--most",        "0"};
  const Finished finished = run(words);
  EXPECT_EQ(finished.status, 1);
  const auto lines = lines_of(finished.out);
  const auto has_line = [&](const std::string& start, const std::string& end) {
    return std::ranges::any_of(lines,
                               [&](const std::string& line) { return line.starts_with(start) && line.ends_with(end); });
  };
  EXPECT_TRUE(finished.out.starts_with("  reason   cases  smallest example\n  refused      2  flat-inputs-0003, "))
      << finished.out;
  EXPECT_TRUE(has_line("  flag", "cases  conforms  refused")) << finished.out;
  EXPECT_TRUE(has_line("  flat-inputs", "2         1        1")) << finished.out;
  EXPECT_TRUE(has_line("flat-inputs-0003 (", "): refuses what is valid")) << finished.out;
  EXPECT_TRUE(has_line("  exit status 1", "")) << finished.out;
  EXPECT_TRUE(has_line("not judged: the orbits of 1 case, without --orbits-against", "")) << finished.out;
  EXPECT_TRUE(has_line("and 1 more; --most shows more", "")) << finished.out;
  EXPECT_TRUE(has_line("4 cases in ", ": 2 conform, 0 where determined, 0 perturbed, 2 negative")) << finished.out;
  EXPECT_TRUE(has_line("does not conform to 1.2 (4 of ", " vectors)")) << finished.out;
  EXPECT_EQ(lines.back(), "fails");
  EXPECT_EQ(finished.err, "");
}

TEST_F(ConformanceCommand, PrintsWhatWasJudged) {
  CITES("FC-CLAIM-03", "FC-PERS-01");
  const Words cases = {"--case", kTriangleOrbits, "--case", kTetrahedronOrbits, "--case", kTrianglePairs};
  const auto printed = [&](Words words) {
    words.insert(words.end(), cases.begin(), cases.end());
    const Finished finished = run(words);
    EXPECT_EQ(finished.status, 0) << finished.err;
    return finished.out;
  };
  const std::string compute = kCompute + ",s2";
  const std::string without = printed({"--against", compute});
  EXPECT_NE(
      unbroken(without).find("\njudged: 3 claims on level 1, 3 claims on level 2, 3 claims on level 3, 3 claims on "
                             "level 4, "),
      std::string::npos)
      << without;
  EXPECT_NE(without.find("\nnot judged: the orbits of 2 cases, without --orbits-against\n"
                         "not judged: the persistence pairs of 1 case, without --persistence-against\n"),
            std::string::npos)
      << without;
  const std::string with =
      printed({"--against", compute, "--orbits-against", kOrbit, "--persistence-against", kPersistence});
  EXPECT_EQ(with.find("not judged"), std::string::npos) << with;
  EXPECT_NE(with.find(", 9 orbits\njudged: the persistence pairs of 1 case"), std::string::npos) << with;
}

// The names of the elements. Fails if the document is not well-formed.
std::vector<std::string> elements_of(const std::string& document) {
  std::vector<std::string> names;
  XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &names);
  XML_SetStartElementHandler(parser, [](void* user, const XML_Char* name, const XML_Char** /*attributes*/) {
    static_cast<std::vector<std::string>*>(user)->emplace_back(name);
  });
  EXPECT_EQ(XML_Parse(parser, document.data(), static_cast<int>(document.size()), 1), XML_STATUS_OK) << document;
  XML_ParserFree(parser);
  return names;
}

TEST_F(ConformanceCommand, WritesAReportForCiSystems) {
  CITES("FC-CLAIM-03", "FC-FILE-29");
  const std::string path = scratch_.path("report & more.xml");
  const Words words = {"--against", script("echo 'a <b> & \001 \"c\"' >&2; exit 1"),
                       "--case",    kTetrahedron,
                       "--case",    "invalid-input-0001",
                       "--case",    "invalid-input-0030",
                       "--junit",   path};
  EXPECT_EQ(run(words).status, 1);
  const std::vector<std::string> names = elements_of(content_of(path));
  EXPECT_EQ(names, (Words{"testsuites", "testsuite", "properties", "property", "testcase", "testcase", "skipped",
                          "testsuite", "properties", "property", "testcase", "failure"}));
  EXPECT_NE(content_of(path).find("value=\"does not conform to 1.2 (2 of "), std::string::npos) << content_of(path);
  EXPECT_NE(content_of(path).find("<testsuite name=\"unstable-manifolds\" tests=\"1\" failures=\"1\" "
                                  "errors=\"0\" skipped=\"0\""),
            std::string::npos)
      << content_of(path);
  EXPECT_NE(content_of(path).find(R"(a &lt;b&gt; &amp; \x01 &quot;c&quot;)"), std::string::npos) << content_of(path);
  // A claim that conforms where it is determined is no failure. The report tells what varies.
  const Words varied = {"--against", script(kPerturbedTriangle), "--case", "regular-stationary-points-0001", "--junit",
                        path};
  EXPECT_EQ(run(varied).status, 0);
  EXPECT_EQ(elements_of(content_of(path)),
            (Words{"testsuites", "testsuite", "properties", "property", "testcase", "system-out"}));
  EXPECT_NE(content_of(path).find("value=\"is perturbed under 1.2, points, approximate within 1e-09 (1 of "),
            std::string::npos)
      << content_of(path);
  EXPECT_NE(content_of(path).find("failures=\"0\""), std::string::npos);
  EXPECT_NE(content_of(path).find("<system-out>level 2: symbolic-perturbation [FC-CLAIM-04]"), std::string::npos)
      << content_of(path);
}

TEST_F(ConformanceCommand, StatesDecimalsWithASmallToleranceAlone) {
  CITES("FC-CLAIM-23", "FC-CLAIM-22");
  const auto words = [&](const std::string& command, const std::string& tolerance) {
    return Words{"--against", command, "--case", "regular-stationary-points-0001", "--tolerance", tolerance};
  };
  const std::string near = script("printf '0,0,0,0\\n0,3,0,0\\n0,0,4,0\\n1,1.5,0,0\\n1,0,2,0\\n' > \"$2\"");
  const json stated = as_json(words(near, "1e-6"))["profile"], none = as_json(words(near, "1.1e-6"))["profile"];
  EXPECT_TRUE(
      stated["statement"].get<std::string>().starts_with("conforms to 1.2, points, approximate within 1e-06 (1 of "))
      << stated;
  EXPECT_TRUE(none["statement"].is_null()) << none;
  EXPECT_EQ(none["grade"], "approximate");
  const Words lines = lines_of(run(words(near, "1.1e-6")).out);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[lines.size() - 2], "no statement: the tolerance 1.1e-06 is above 1e-06 (FC-CLAIM-23)");
  EXPECT_EQ(lines.back(), "conforms");
  const json exact = as_json(words(kCompute, "0.001"))["profile"];
  EXPECT_TRUE(exact["statement"].get<std::string>().starts_with("conforms to 1.2, points")) << exact;
}

TEST_F(ConformanceCommand, KeepsWhatIsNeededToSeeForOneself) {
  CITES("FC-CLAIM-03");
  const std::string folder = scratch_.path("kept/here");
  const std::string command = script("echo said; echo complained >&2; echo '# nothing' > \"$2\"");
  EXPECT_EQ(run({"--against", command, "--case", kTetrahedron, "--case", "flat-inputs-0001", "--keep", folder}).status,
            1);
  EXPECT_FALSE(fs::exists(folder + "/flat-inputs-0001")) << "nothing is right for no points";
  const std::string kept = folder + "/" + kTetrahedron;
  EXPECT_EQ(content_of(kept + "/points.xyz"), "0 0 0\n1 1 0\n1 0 1\n0 1 1\n");
  EXPECT_EQ(content_of(kept + "/claim"), "# nothing\n");
  EXPECT_EQ(content_of(kept + "/stdout"), "said\n");
  EXPECT_EQ(content_of(kept + "/stderr"), "complained\n");
  EXPECT_EQ(json::parse(content_of(kept + "/case.json"))["id"], kTetrahedron);
  EXPECT_EQ(flowcert({"check", kept + "/points.xyz", kept + "/claim"}).status, 1);
  // Another run leaves nothing of this one, and does not wait for a pipe.
  EXPECT_EQ(run({"--against", script("mkfifo \"$2\""), "--case", kTetrahedron, "--keep", folder}).status, 1);
  EXPECT_FALSE(fs::exists(kept + "/claim"));
  EXPECT_EQ(content_of(kept + "/stdout"), "");
  // Where a folder cannot be made, the run ends, however many cases run at a time.
  const std::string other = scratch_.path("other");
  fs::create_directory(other);
  for (const char* id : {kTetrahedron, "unstable-manifolds-0003"}) std::ofstream(other + "/" + id) << "in the way";
  const Finished ended = run({"--against", command, "--group", "unstable-manifolds", "--keep", other, "--jobs", "2"});
  EXPECT_EQ(ended.status, 2) << ended.out;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(lines_of(ended.err).size(), 1U) << ended.err;
  EXPECT_NE(ended.err.find("unstable-manifolds-000"), std::string::npos) << ended.err;
}

// On a terminal a line tells how many cases are done, from two seconds on, and is taken back in the end.
TEST_F(ConformanceCommand, TellsAUserHowFarItIs) {
  CITES("FC-CLAIM-03");
  const std::string typed = std::string(FLOWCERT_PROGRAM) + " conformance --vectors '" + few_vectors->folder() +
                            "' --group flat-inputs --against 'sleep 0.6; exit 1 # {in}' > '" + scratch_.path("out") +
                            "'";
  const std::string seen = RunningProgram({"/usr/bin/script", "-qec", typed, "/dev/null"}).finish().out;
  EXPECT_NE(seen.find("\rcases [#"), std::string::npos) << seen;
  EXPECT_NE(seen.find(" s left\033[K"), std::string::npos) << seen;
  EXPECT_TRUE(seen.ends_with("\r\033[K")) << seen;
  EXPECT_NE(content_of(scratch_.path("out")).find("6 cases in "), std::string::npos);
}

// The README's example, in a folder with a program build/flowcert.
TEST_F(ConformanceCommand, DoesWhatTheReadmeSays) {
  CITES("FC-CLAIM-03");
  const auto lines = lines_of(content_of(FLOWCERT_FUZZ_README));
  auto line = std::ranges::find(lines, "<!-- example: conformance -->");
  ASSERT_LT(line, lines.end() - 3);
  std::string typed = *(line += 2);
  while (typed.ends_with('\\') && ++line != lines.end()) typed += '\n' + *line;
  ASSERT_TRUE(typed.starts_with("$ ")) << typed;
  fs::create_directory(scratch_.path("build"));
  fs::create_symlink(FLOWCERT_PROGRAM, scratch_.path("build/flowcert"));
  const Finished finished =
      RunningProgram({"/bin/sh", "-c", "cd " + scratch_.path("") + " && " + typed.substr(2)}).finish();
  EXPECT_EQ(finished.status, 0) << finished.err;
  const auto printed = lines_of(finished.out);
  for (++line; line != lines.end() && !line->starts_with("```"); ++line) {
    EXPECT_TRUE(*line == "..." || std::ranges::find(printed, *line) != printed.end()) << *line << finished.out;
  }
}

// Each of the commands is tried once, before the first case.
TEST_F(ConformanceCommand, RefusesACommandThatDoesNotExist) {
  const std::string told = scratch_.path("told");
  const std::string answers = "echo >>" + told + "; echo # {in}";
  for (const Words& options : {Words{"--against", "no-such-program {in}"},
                               Words{"--against", answers, "--orbits-against", "no-such-program {in} {start}"},
                               Words{"--against", answers, "--persistence-against", "/no/such/program {in}"},
                               Words{"--against", "/etc/passwd {in}", "--in-format", "off"}}) {
    Words words = {"conformance"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_TRUE(
        std::regex_match(finished.err, std::regex("flowcert: --[a-z-]*against: the command was not started: .*\n")))
        << finished.err;
  }
  EXPECT_EQ(content_of(told), "\n\n");
}

// A relative path means something only where the user is.
TEST_F(ConformanceCommand, AsksForFullPaths) {
  CITES("FC-IN-05", "FC-FILE-26");
  const std::string relative = fs::relative(FLOWCERT_PROGRAM, fs::current_path()).string();
  const std::string path = relative.find('/') == std::string::npos ? "./" + relative : relative;
  const Finished finished = run({"--against", path + " compute {in} -o {out}", "--case", kTetrahedron});
  EXPECT_EQ(finished.status, 2) << finished.out;
  EXPECT_NE(finished.err.find("$PWD/"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace flowcert::conformance::conformance_command_test
