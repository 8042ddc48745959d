// All that a function of recorded numbers may answer: a tree of the comparisons that it asks for, with what it answers
// at its leaves.
//
// Guarantees: the tree is what the function does, for every answer of every comparison, in the order in which they are
// asked for. The function has to be a function: it is called once for each path.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "tests/proofs/recorded_number.h"

namespace flowcert::proofs {

template <class Answer>
struct DecisionTree {
  Answer answer{};  // of a leaf
  Comparison comparison{};
  std::unique_ptr<DecisionTree> yes, no;  // nothing for a leaf

  [[nodiscard]] bool is_leaf() const { return yes == nullptr; }
};

template <class Function>
[[nodiscard]] auto recorded_function(const Function& function, std::vector<bool> answers = {})
    -> DecisionTree<decltype(function())> {
  DecisionTree<decltype(function())> tree;
  Path::begin(answers);
  tree.answer = function();
  if (Path::asked().size() == answers.size()) return tree;
  tree.comparison = Path::asked()[answers.size()];
  const auto branch = [&](bool answer) {
    std::vector<bool> longer = answers;
    longer.push_back(answer);
    return std::make_unique<decltype(tree)>(recorded_function(function, std::move(longer)));
  };
  tree.yes = branch(true);
  tree.no = branch(false);
  return tree;
}

}  // namespace flowcert::proofs
