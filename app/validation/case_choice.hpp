#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "effect/effect_draw.hpp"
#include "validation/synthetic_body.hpp"

namespace myo::validation {

/// Kind of a case by its truth.
enum class CaseKind {
    none,     // the declared model is complete
    named,    // one effect acts, or CaseChoice::together of them; the diagnosis knows all
    deleted,  // one effect acts that is withheld from the diagnosis
};
/// Id of a kind.
std::string to_string(CaseKind kind);
/// Kind of an id; false if there is none.
bool parse_case_kind(const std::string& id, CaseKind& kind);

/// The set from which the cases of a validation are drawn.
struct CaseChoice {
    std::uint64_t seed = 1;
    std::vector<BodyFamily> families;  // empty: all
    std::vector<std::string> effects;  // ids; empty: the whole catalogue
    int together = 1;                  // effects that act in a case of CaseKind::named
};

/// Checks that every effect of the choice can be drawn.
///
/// Errors (place: the option): an unknown effect, one that no body of the choice can show, or more effects together
/// than the choice holds or a diagnosis names.
Result<void> check_choice(const CaseChoice& choice);

/// Second part of the key of a random stream of a validation; the first is the seed.
enum Purpose : std::uint64_t { order_of_effects = 1, the_case = 2, the_noise = 3, further_effects = 4 };

/// Kind of a case by its place in a cycle of six: none, named, named, deleted, named, named.
CaseKind kind_of(int number);

/// Ids of the effects of a case; empty for CaseKind::none. The first cycles through the catalogue, the others are drawn
/// at random from those that one body can show with it: fewer than wanted where no body can show more.
///
/// @param attempt  another draw of those after the first
std::vector<std::string> effects_of(const CaseChoice& choice, int number, int attempt);

/// What a body must have to show all of these effects.
effect::EffectNeeds needs_of(const std::vector<std::string>& effects);

/// Whether bodies of the family bend by an antagonist pair along their length.
bool may_have_muscles(BodyFamily family);

/// Random family of the choice that has what is needed; there must be one.
BodyFamily drawn_family(const CaseChoice& choice, const effect::EffectNeeds& needs, RandomStream& random);

}  // namespace myo::validation
