#include "tests/vectors/pore_vectors.h"

#include <algorithm>
#include <stdexcept>

#include "oracle/fast/near_balls.h"
#include "oracle/pores.h"
#include "oracle/program/pores_field.h"
#include "oracle/program/read_balls.h"
#include "oracle/program/read_points.h"

namespace oracle::vectors {

namespace {

struct PoreAnswer {
  Rational depth;
  std::optional<Rational> probe;
  Pores found;
};

// What the oracle found out for one case. Balls that have to be refused have no answer.
struct PoreFindings {
  std::vector<Ball> balls;
  Places visible;
  std::vector<BallPoint> points;
  std::vector<PoreAnswer> answers;
};

// ---- Flags ----

template <class Holds>
bool some_point(const PoreFindings& found, const Holds& holds) {
  return std::any_of(found.points.begin(), found.points.end(), holds);
}

template <class Holds>
bool some_answer(const PoreFindings& found, const Holds& holds) {
  return std::any_of(found.answers.begin(), found.answers.end(), holds);
}

template <class Holds>
bool some_chamber(const PoreFindings& found, const Holds& holds) {
  return some_answer(found, [&](const PoreAnswer& answer) {
    const auto& all = answer.found.chambers;
    return std::any_of(all.begin(), all.end(), [&](const Chamber& chamber) { return holds(answer, chamber); });
  });
}

bool is_hidden(const PoreFindings& found, std::size_t ball) {
  return !std::binary_search(found.visible.begin(), found.visible.end(), ball);
}

bool has_hidden_contact(const PoreFindings& found) {
  return some_point(found, [&](const BallPoint& point) {
    return std::any_of(point.contacts.begin(), point.contacts.end(),
                       [&](std::size_t id) { return is_hidden(found, id); });
  });
}

bool touches(const BallPoint& point) { return point.index == 1 && point.value.sign() == 0; }

bool has_surplus(const BallPoint& point) { return point.contacts.size() > static_cast<std::size_t>(point.index) + 1; }

bool have_one_radius(const PoreFindings& found) {
  const std::vector<Ball>& balls = found.balls;
  return balls.size() > 1 &&
         std::all_of(balls.begin(), balls.end(), [&](const Ball& ball) { return ball.radius == balls[0].radius; });
}

bool is_no_double(const Rational& number) { return Rational(number.convert_to<double>()) != number; }

bool has_no_double(const PoreFindings& found) {
  return std::any_of(found.balls.begin(), found.balls.end(), [](const Ball& ball) {
    return is_no_double(ball.radius) || std::any_of(ball.centre.begin(), ball.centre.end(), is_no_double);
  });
}

double nearest(const Quadratic& x) { return nearest_difference(x, {}); }

// Values descend.
bool has_two_values_of_one_double(const PoreFindings& found) {
  for (std::size_t k = 1; k < found.points.size(); ++k) {
    const Quadratic &above = found.points[k - 1].value, &below = found.points[k].value;
    if (above != below && nearest(above) == nearest(below)) return true;
  }
  return false;
}

const Quadratic& value(const Pores& pores, std::size_t point) { return pores.points[point].value; }

bool has_low_exit(const PoreAnswer& answer, const Chamber& chamber) {
  if (chamber.gates.empty()) return false;
  return !chamber.exit || *chamber.exit < value(answer.found, chamber.gates[0]);
}

bool has_window_below_gate(const PoreAnswer& answer, const Chamber& chamber) {
  return std::any_of(chamber.windows.begin(), chamber.windows.end(), [&](std::size_t window) {
    const std::size_t point = answer.found.windows[window].point;
    return value(answer.found, point) < value(answer.found, chamber.gates[0]);
  });
}

bool passes_exactly(const PoreAnswer& answer, const Chamber& chamber) {
  if (!answer.probe) return false;
  const bool is_gate = !chamber.gates.empty() && value(answer.found, chamber.gates[0]) == *answer.probe;
  return is_gate || value(answer.found, chamber.peaks[0]) == *answer.probe;
}

struct PoreFlag {
  const char* name;
  const char* meaning;
  const char* clauses;  // parted by blanks
  bool (*holds)(const PoreFindings&);
};

constexpr PoreFlag kPoreFlags[] = {
    {"few-balls", "Fewer than four balls.", "FC-BALL-01",
     [](const PoreFindings& found) { return found.balls.size() < 4; }},
    {"not-doubles", "A coordinate or a radius that is no double.", "FC-BALL-01", has_no_double},
    {"hidden-ball", "A hidden ball.", "FC-BALL-02",
     [](const PoreFindings& found) { return found.visible.size() < found.balls.size(); }},
    {"hidden-contact", "A hidden ball that is a contact of a critical point.", "FC-BALL-02", has_hidden_contact},
    {"touching-balls", "Two balls that touch, at a critical point of index 1 and value 0.", "FC-BALL-02",
     [](const PoreFindings& found) { return some_point(found, touches); }},
    {"flat-centres", "Centres that do not span space.", "FC-BALL-04",
     [](const PoreFindings& found) { return affine_dimension(centres(found.balls)) < 3; }},
    {"one-radius", "Two balls or more, and all radii are equal.", "FC-BALL-04 FC-BALL-10", have_one_radius},
    {"surplus-contacts", "A critical point with more contacts than its index and one.", "FC-BALL-04",
     [](const PoreFindings& found) { return some_point(found, has_surplus); }},
    {"two-of-one-double", "Two critical points whose values are different and have one nearest double.", "FC-BALL-08",
     has_two_values_of_one_double},
    {"chamber", "A listed chamber.", "FC-BALL-10",
     [](const PoreFindings& found) { return some_chamber(found, [](const auto&, const Chamber&) { return true; }); }},
    {"no-chamber", "A depth at which no chamber is listed.", "FC-BALL-05",
     [](const PoreFindings& found) {
       return some_answer(found, [](const PoreAnswer& answer) { return answer.found.chambers.empty(); });
     }},
    {"gate-below-0", "A listed chamber whose gate is below 0.", "FC-BALL-05",
     [](const PoreFindings& found) {
       return some_chamber(found, [](const auto&, const Chamber& chamber) { return chamber.gates.empty(); });
     }},
    {"low-exit", "A listed chamber whose exit is less than its gate.", "FC-BALL-05",
     [](const PoreFindings& found) { return some_chamber(found, has_low_exit); }},
    {"chamber-of-two-peaks", "A listed chamber with two peak points or more.", "FC-BALL-05",
     [](const PoreFindings& found) {
       return some_chamber(found, [](const auto&, const Chamber& chamber) { return chamber.peaks.size() > 1; });
     }},
    {"two-witnesses", "A listed chamber with two witnesses of its gate or more.", "FC-BALL-05",
     [](const PoreFindings& found) {
       return some_chamber(found, [](const auto&, const Chamber& chamber) { return chamber.gates.size() > 1; });
     }},
    {"window-below-gate", "A window of a chamber whose value is less than that of its gate.", "FC-BALL-09",
     [](const PoreFindings& found) { return some_chamber(found, has_window_below_gate); }},
    {"handle", "A handle of a listed chamber.", "FC-BALL-09",
     [](const PoreFindings& found) {
       return some_chamber(found, [](const auto&, const Chamber& chamber) { return !chamber.handles.empty(); });
     }},
    {"vestibule", "A vestibule.", "FC-BALL-09",
     [](const PoreFindings& found) {
       return some_answer(found, [](const PoreAnswer& answer) { return !answer.found.vestibules.empty(); });
     }},
    {"probe", "A probe.", "FC-BALL-06",
     [](const PoreFindings& found) {
       return some_answer(found, [](const PoreAnswer& answer) { return answer.probe.has_value(); });
     }},
    {"probe-passes-exactly", "A probe that is just as wide as a listed chamber's gate or peak.", "FC-BALL-06",
     [](const PoreFindings& found) { return some_chamber(found, passes_exactly); }},
};

// ---- Fields ----

Json contacts_field(const BallPoint& point) { return point.contacts; }

Json center_field(const BallPoint& point) {
  Json field = Json::array();
  for (const Quadratic& coordinate : point.position) field.push_back(number_field(coordinate));
  return field;
}

Json witnesses_field(const Pores& pores, const Places& points) {
  if (points.empty()) return nullptr;
  Json field;
  field["value"] = number_field(value(pores, points[0]));
  field["points"] = Json::array();
  for (const std::size_t place : points) {
    Json& one = field["points"].emplace_back();
    one["contact"] = contacts_field(pores.points[place]);
    one["center"] = center_field(pores.points[place]);
  }
  return field;
}

double twice(const Quadratic& x) { return nearest(x * Quadratic(Rational(2))); }

Json diameter_field(const std::optional<Quadratic>& radius) {
  if (!radius) return nullptr;
  return twice(*radius);
}

Json window_field(const Pores& pores, const Window& window) {
  Json field;
  field["value"] = number_field(value(pores, window.point));
  field["diameter"] = twice(value(pores, window.point));
  field["contact"] = contacts_field(pores.points[window.point]);
  field["center"] = center_field(pores.points[window.point]);
  for (const std::size_t room : window.rooms) {
    field["rooms"].push_back(room == outside_room(pores) ? -1 : static_cast<std::int64_t>(room));
  }
  return field;
}

const char* status_of(const Pores& pores, const Chamber& chamber, const Rational& probe) {
  if (value(pores, chamber.peaks[0]) < probe) return "too small";
  return chamber.gates.empty() || value(pores, chamber.gates[0]) < probe ? "closed" : "open";
}

Json chamber_field(const PoreAnswer& answer, const Chamber& chamber) {
  const Pores& pores = answer.found;
  const Quadratic& peak = value(pores, chamber.peaks[0]);
  Json field;
  field["peak"] = witnesses_field(pores, chamber.peaks);
  field["gate"] = witnesses_field(pores, chamber.gates);
  field["depth"] = nearest_difference(peak, chamber.gates.empty() ? Quadratic() : value(pores, chamber.gates[0]));
  field["exit"] = chamber.exit ? number_field(*chamber.exit) : Json(nullptr);
  field["diameter"] = twice(peak);
  field["limiting_diameter"] = diameter_field(chamber.exit);
  field["windows"] = chamber.windows;
  field["handles"] = Json::array();
  for (const std::size_t handle : chamber.handles) field["handles"].push_back(contacts_field(pores.points[handle]));
  if (answer.probe) field["is"] = status_of(pores, chamber, *answer.probe);
  return field;
}

std::size_t cavities_at(const Pores& pores, const Rational& probe) {
  return static_cast<std::size_t>(std::count_if(
      pores.cavities.begin(), pores.cavities.end(),
      [&](const Cavity& cavity) { return (!cavity.gate || *cavity.gate < probe) && cavity.peak >= Quadratic(probe); }));
}

Json hidden_field(const PoreFindings& found) {
  Json field = Json::array();
  for (std::size_t id = 0; id < found.balls.size(); ++id) {
    if (is_hidden(found, id)) field.push_back(id);
  }
  return field;
}

// What pores.md says, without what is of a program and of a file.
Json answer_field(const PoreFindings& found, const PoreAnswer& answer) {
  const Pores& pores = answer.found;
  Json field;
  field["hidden"] = hidden_field(found);
  field["depth"] = answer.depth.str();
  field["probe"] = answer.probe ? Json(answer.probe->str()) : Json(nullptr);
  if (answer.probe) field["cavities_at_probe"] = cavities_at(pores, *answer.probe);
  std::optional<Quadratic> peak, exit;
  for (const Chamber& chamber : pores.chambers) {
    if (!peak || *peak < value(pores, chamber.peaks[0])) peak = value(pores, chamber.peaks[0]);
    if (chamber.exit && (!exit || *exit < *chamber.exit)) exit = chamber.exit;
  }
  field["largest_cavity_diameter"] = diameter_field(peak);
  field["pore_limiting_diameter"] = diameter_field(exit);
  for (const char* list : {"vestibules", "windows", "cavities", "chambers"}) field[list] = Json::array();
  for (const Vestibule& each : pores.vestibules) field["vestibules"].push_back(witnesses_field(pores, each.peaks));
  for (const Window& each : pores.windows) field["windows"].push_back(window_field(pores, each));
  for (const Cavity& each : pores.cavities) {
    field["cavities"].push_back({each.gate ? number_field(*each.gate) : Json(nullptr), number_field(each.peak)});
  }
  for (const Chamber& each : pores.chambers) field["chambers"].push_back(chamber_field(answer, each));
  return field;
}

Json points_field(const PoreFindings& found) {
  Json field = Json::array();
  for (const BallPoint& point : found.points) {
    Json& one = field.emplace_back();
    one["index"] = point.index;
    one["contact"] = contacts_field(point);
    one["value"] = number_field(point.value);
    one["center"] = center_field(point);
  }
  return field;
}

// ---- Cases ----

PoreFindings findings_of(const PoreRecipe& recipe) {
  PoreFindings found;
  for (const BallWords& words : recipe.balls) {
    const auto number = [&](std::size_t k) { return exact_number(words[k], recipe.id + ": "); };
    found.balls.push_back({{number(0), number(1), number(2)}, number(3)});
  }
  found.visible = visible_balls(found.balls);
  found.points = fast::critical_points(found.balls);
  for (const PoreQuestion& question : recipe.questions) {
    const Rational depth = exact_number(question.depth, recipe.id + ": ");
    std::optional<Rational> probe;
    if (question.probe) probe = exact_number(*question.probe, recipe.id + ": ");
    found.answers.push_back({depth, probe, pores(found.balls, found.points, depth)});
  }
  return found;
}

// Ascending, each once.
Json clauses_field(std::string words, const std::vector<std::string>& flags) {
  for (const PoreFlag& flag : kPoreFlags) {
    const bool is_set = std::find(flags.begin(), flags.end(), flag.name) != flags.end();
    if (is_set) words += std::string(" ") + flag.clauses;
  }
  std::vector<std::string> clauses = fields(words);
  std::sort(clauses.begin(), clauses.end());
  clauses.erase(std::unique(clauses.begin(), clauses.end()), clauses.end());
  return clauses;
}

}  // namespace

Json pore_case(const PoreRecipe& recipe) {
  const bool is_invalid = recipe.questions.empty();
  const PoreFindings found = is_invalid ? PoreFindings() : findings_of(recipe);
  std::vector<std::string> flags;
  for (const PoreFlag& flag : kPoreFlags) {
    if (!is_invalid && flag.holds(found)) flags.emplace_back(flag.name);
  }
  Json made;
  made["id"] = recipe.id;
  made["comment"] = recipe.comment;
  made["flags"] = flags;
  std::string clauses = is_invalid ? "FC-BALL-01" : "FC-BALL-01 FC-BALL-03 FC-BALL-05 FC-BALL-07 FC-BALL-08 FC-BALL-09";
  if (!recipe.claims.empty()) clauses += " FC-CLAIM-26";
  made["clauses"] = clauses_field(clauses, flags);
  made["balls"] = recipe.balls;
  made["result"] = is_invalid ? "invalid" : "determined";
  if (is_invalid) return made;
  made["expected"]["points"] = points_field(found);
  for (const PoreAnswer& answer : found.answers) made["expected"]["pores"].push_back(answer_field(found, answer));
  for (const PoreClaim& claim : recipe.claims) {
    Json& field = made["expected"]["claims"].emplace_back();
    field["claim"] = claim.lines;
    field["reasons"] = claim.reasons;
  }
  return made;
}

Json pore_file(const std::vector<Json>& cases) {
  Json file;
  file["format"] = "flowcert-ball-vectors";
  file["format_version"] = 1;
  file["generator"] = "flowcert-make-vectors";
  file["group"] = "pores";
  file["title"] = "Chambers between balls, with gates, exits and windows";
  for (const PoreFlag& flag : kPoreFlags) {
    Json& field = file["flags"].emplace_back();
    field["flag"] = flag.name;
    field["meaning"] = flag.meaning;
    field["clauses"] = fields(flag.clauses);
  }
  file["cases"] = cases;
  return file;
}

}  // namespace oracle::vectors
