// A damage changes the tree before it is written, or the text afterwards.
#include "torse/fuzz/draw/damage.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "torse/fuzz/draw/damages.hpp"
#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

DamagedFile damaged_tree(Choices& choices, DrawnFile file, const TreeDamage& damage) {
  const std::string place = damage.damage(choices, file);
  const WrittenJson written = write_json(choices, file.tree);
  DamagedFile damaged{file.meant.type, damage.name, written.text, place, LineColumn{0, 0}};
  if (!place.empty()) damaged.at = line_column(written.text, written.values.at(place));
  return damaged;
}

DamagedFile damaged_text(Choices& choices, DrawnFile file, const TextDamage& damage) {
  auto [text, offset] = damage.damage(choices, file);
  DamagedFile damaged{file.meant.type, damage.name, std::move(text), "", std::nullopt};
  if (offset) damaged.at = line_column(damaged.text, *offset);
  return damaged;
}

}  // namespace

DamagedFile draw_damaged_file(Choices& choices, const Scale& scale, Labels& labels) {
  DrawnFile file = draw_file(choices, scale, labels);
  const std::span<const TreeDamage> values = value_damages();
  const std::span<const TextDamage> syntax = syntax_damages();
  const std::size_t own = file.meant.type == "construct" ? 4 : 0;
  const std::size_t kind = choices.below(values.size() + syntax.size() + own);
  DamagedFile damaged = kind < values.size() ? damaged_tree(choices, std::move(file), values[kind])
                        : kind < values.size() + syntax.size()
                            ? damaged_text(choices, std::move(file), syntax[kind - values.size()])
                            : damaged_tree(choices, std::move(file), construction_damage());
  labels.add("damage", damaged.damage);
  return damaged;
}

std::string scrambled(Choices& choices, std::string text) {
  constexpr std::string_view likely = "0123456789-+.eE/xX\"[]{}:, \n\\ntruefalse";
  const bool numbers = choices.below(2) == 0;
  for (int left = choices.between(1, 8); left > 0 && !text.empty(); --left) {
    std::size_t at = choices.below(text.size());
    if (numbers) at = std::min(text.find_first_of("0123456789", at), text.size() - 1);
    const std::size_t run = std::min<std::size_t>(1 + choices.below(12), text.size() - at);
    switch (choices.below(numbers ? 2 : 7)) {
      case 0:
        text[at] = static_cast<char>('0' + choices.below(10));
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text.erase(at, run);
        break;
      case 3:
        text[at] = likely[choices.below(likely.size())];
        break;
      case 4:
        text[at] = static_cast<char>(choices.below(256));
        break;
      case 5:
        text.insert(at, 1, likely[choices.below(likely.size())]);
        break;
      default:
        text.insert(choices.below(text.size()), text.substr(at, run));
    }
  }
  return text;
}

}  // namespace torse::fuzz
