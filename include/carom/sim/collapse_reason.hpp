#pragma once
// Why a run of infinitely many impacts stops, and what its scene can do about it.

#include <string>

#include "carom/scene/scene.hpp"

namespace carom {

/// What the last ball of a collapse met.
enum class Support : std::uint8_t { ball, corner, curve };

/// For a person: reason and remedies.
[[nodiscard]] inline std::string collapse_reason(Regularise regularise, Support support) {
  const std::string what =
      "infinitely many dissipating impacts in finite time: inelastic collapse, or a contact that never ends";
  if (regularise == Regularise::viscoelastic)
    return what +
           ". Viscoelastic balls come to rest under a force too. Remedies: collision.regularise = \"rest\", "
           "collision.contact_time, restitution = 1";
  if (regularise != Regularise::rest)
    return what +
           ". Remedies: collision.contact_time, collision.regularise = \"viscoelastic\" or \"rest\" (on flat "
           "walls, under an acceleration), restitution = 1";
  const std::string where = support == Support::ball     ? "on another ball"
                            : support == Support::corner ? "in a corner of flat walls"
                                                         : "on a curved wall or at the end of one";
  return what + ". A ball comes to rest " + where +
         ", and collision.regularise = \"rest\" holds balls on one flat wall only. Remedies: a (longer) "
         "collision.contact_time, "
         "restitution = 1";
}

}  // namespace carom
