#pragma once
// The words of a scene file that stand for a choice, each with the choice it names.

#include <array>
#include <span>
#include <string_view>

#include "carom/scene/scene.hpp"

namespace carom::scene_text {

template <class E>
struct Word {
  std::string_view text;
  E value;
};

inline constexpr std::array space_kinds{Word<SpaceKind>{"open", SpaceKind::open}, Word<SpaceKind>{"box", SpaceKind::box},
                                        Word<SpaceKind>{"periodic", SpaceKind::periodic}};

inline constexpr std::array law_kinds{Word<LawKind>{"restitution", LawKind::restitution},
                                      Word<LawKind>{"stick", LawKind::stick}, Word<LawKind>{"merge", LawKind::merge}};

inline constexpr std::array simultaneous_rules{Word<Simultaneous>{"sequential", Simultaneous::sequential},
                                               Word<Simultaneous>{"symmetric", Simultaneous::symmetric}};

inline constexpr std::array regularise_kinds{Word<Regularise>{"rest", Regularise::rest},
                                             Word<Regularise>{"viscoelastic", Regularise::viscoelastic}};

inline constexpr std::array lattice_kinds{Word<LatticeKind>{"chain", LatticeKind::chain},
                                          Word<LatticeKind>{"square", LatticeKind::square},
                                          Word<LatticeKind>{"hexagonal", LatticeKind::hexagonal},
                                          Word<LatticeKind>{"cubic", LatticeKind::cubic},
                                          Word<LatticeKind>{"fcc", LatticeKind::fcc},
                                          Word<LatticeKind>{"rack", LatticeKind::rack}};

inline constexpr std::array wall_kinds{Word<WallKind>{"segment", WallKind::segment},
                                       Word<WallKind>{"plane", WallKind::plane}, Word<WallKind>{"circle", WallKind::circle},
                                       Word<WallKind>{"polygon", WallKind::polygon}, Word<WallKind>{"arc", WallKind::arc},
                                       Word<WallKind>{"ellipse", WallKind::ellipse},
                                       Word<WallKind>{"parabola", WallKind::parabola},
                                       Word<WallKind>{"curve", WallKind::curve}};

inline constexpr std::array wall_sides{Word<WallSide>{"inside", WallSide::inside},
                                       Word<WallSide>{"outside", WallSide::outside}};

inline constexpr std::array table_kinds{
    Word<TableKind>{"rectangle", TableKind::rectangle}, Word<TableKind>{"circle", TableKind::circle},
    Word<TableKind>{"ellipse", TableKind::ellipse},     Word<TableKind>{"stadium", TableKind::stadium},
    Word<TableKind>{"mushroom", TableKind::mushroom},   Word<TableKind>{"sinai", TableKind::sinai},
    Word<TableKind>{"lorentz", TableKind::lorentz},     Word<TableKind>{"polygon", TableKind::polygon},
    Word<TableKind>{"triangle", TableKind::triangle},   Word<TableKind>{"wedge", TableKind::wedge},
    Word<TableKind>{"cardioid", TableKind::cardioid},   Word<TableKind>{"pinball", TableKind::pinball},
    Word<TableKind>{"annulus", TableKind::annulus},     Word<TableKind>{"cradle", TableKind::cradle},
    Word<TableKind>{"pool", TableKind::pool}};

inline constexpr std::array table_lattices{Word<TableLattice>{"triangular", TableLattice::triangular},
                                           Word<TableLattice>{"square", TableLattice::square}};

inline constexpr std::array search_kinds{
    Word<SearchKind>{"auto", SearchKind::automatic}, Word<SearchKind>{"all_pairs", SearchKind::all_pairs},
    Word<SearchKind>{"cells", SearchKind::cells}, Word<SearchKind>{"neighbour_list", SearchKind::neighbour_list}};

inline constexpr std::array queue_kinds{Word<QueueKind>{"auto", QueueKind::automatic},
                                        Word<QueueKind>{"heap", QueueKind::heap},
                                        Word<QueueKind>{"calendar", QueueKind::calendar}};

inline constexpr std::array frame_kinds{Word<FramesAt>{"samples", FramesAt::samples},
                                        Word<FramesAt>{"events", FramesAt::events}};

inline constexpr std::array combinations{Word<Combine>{"grid", Combine::grid}, Word<Combine>{"zip", Combine::zip}};

/// The word for a choice. A value that is none of the list (a wild cast) gives an empty word.
template <class E>
[[nodiscard]] std::string_view word_for(std::span<const Word<E>> words, E value) {
  for (const Word<E>& word : words) {
    if (word.value == value) return word.text;
  }
  return {};
}

}  // namespace carom::scene_text
