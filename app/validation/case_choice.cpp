#include "validation/case_choice.hpp"

#include <algorithm>
#include <cassert>

#include "base/name_table.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "effect/catalogue.hpp"
#include "validation/synthetic_effects.hpp"

namespace myo::validation {
namespace {

constexpr NameTable<CaseKind, 3> kinds{
    {{{CaseKind::none, "none"}, {CaseKind::named, "named"}, {CaseKind::deleted, "deleted"}}}};
/// The cycle of kind_of().
constexpr int round_length = 6, deleted_at = 3, named_in_round = 4;

/// Index of a case among those of its kind.
int turn_of(int number) {
    const int round = number / round_length, place = number % round_length;
    if (kind_of(number) != CaseKind::named) return round;
    return named_in_round * round + place - (place < deleted_at ? 1 : 2);
}

/// Families of the choice; of all of them, bodies with a tendon serve the effects that need one only.
std::vector<BodyFamily> families_of(const CaseChoice& choice, const effect::EffectNeeds& needs) {
    if (!choice.families.empty()) return choice.families;
    if (needs.tendon) return {BodyFamily::threaded};
    return {BodyFamily::beam, BodyFamily::plate, BodyFamily::ell, BodyFamily::tail};
}

/// Tetrahedra do not conform to the inner plane of a clamp: a tail clamped over a part of its length would be clamped
/// less in its model.
bool may_be_held_deep(BodyFamily family) { return family != BodyFamily::tail; }

/// Whether a body of the family can have what an effect needs.
bool fits(BodyFamily family, const effect::EffectNeeds& needs) {
    const bool threaded = family == BodyFamily::threaded;
    // The trials of a thread have no other loads. No body is bent far between two guides: between them a straight
    // thread and one in a channel are the same within the noise.
    return !needs.far_guides && (!needs.tendon || threaded) && (!needs.hung_weight || !threaded) &&
           (!needs.muscles || may_have_muscles(family)) && (!needs.deep_clamp || may_be_held_deep(family));
}

/// Whether some body of the choice has all of this.
bool can_show(const CaseChoice& choice, const effect::EffectNeeds& needs) {
    const std::vector<BodyFamily> families = families_of(choice, needs);
    return std::any_of(families.begin(), families.end(), [&](BodyFamily family) { return fits(family, needs); });
}

/// Effects that are drawn from: those of the choice, or all of the catalogue that a body can show.
std::vector<std::string> ids_of(const CaseChoice& choice) {
    if (!choice.effects.empty()) return choice.effects;
    std::vector<std::string> ids;
    for (const std::string& id : effect::effect_ids())
        if (can_show(choice, effect_draw(id).needs)) ids.push_back(id);
    return ids;
}

/// Fisher-Yates.
void shuffle(std::vector<std::string>& ids, RandomStream& random) {
    for (int i = static_cast<int>(ids.size()) - 1; i > 0; --i)
        std::swap(ids[static_cast<std::size_t>(i)], ids[static_cast<std::size_t>(random.below(i + 1))]);
}

/// Each effect once per cycle through the catalogue, in a new random order each time.
std::string effect_of(const CaseChoice& choice, int number) {
    std::vector<std::string> ids = ids_of(choice);
    const int count = static_cast<int>(ids.size()), turn = turn_of(number);
    RandomStream random{choice.seed, order_of_effects, static_cast<std::uint64_t>(kind_of(number)),
                        static_cast<std::uint64_t>(turn / count)};
    shuffle(ids, random);
    return ids[static_cast<std::size_t>(turn % count)];
}

/// What a body must have to show two effects.
effect::EffectNeeds both(const effect::EffectNeeds& a, const effect::EffectNeeds& b) {
    return {a.muscles || b.muscles,
            a.tendon || b.tendon,
            a.far_guides || b.far_guides,
            a.deep_clamp || b.deep_clamp,
            a.hung_weight || b.hung_weight,
            a.known_damping || b.known_damping,
            a.straight_start || b.straight_start};
}

bool shortens_clamp(const std::string& id) { return !effect::find_effect(id)->clamp_shortening.empty(); }

}  // namespace

std::string to_string(CaseKind kind) { return kinds.name(kind); }
bool parse_case_kind(const std::string& id, CaseKind& kind) { return kinds.find(id, kind); }

Result<void> check_choice(const CaseChoice& choice) {
    for (const std::string& id : choice.effects) {
        if (effect::find_effect(id) == nullptr) return Error{"no effect '" + id + "' is known", "--effects"};
        if (!can_show(choice, effect_draw(id).needs))
            return Error{
                id + (effect_draw(id).needs.far_guides    ? " needs a body that a thread bends far, which none is"
                      : effect_draw(id).needs.tendon      ? " needs a tendon, which only threaded has"
                      : effect_draw(id).needs.hung_weight ? " needs a hung weight, which threaded has not"
                      : effect_draw(id).needs.muscles     ? " needs muscles, which only beam and tail have"
                                                      : " needs a clamp over a part of the length, which tail has not"),
                "--geometry"};
    }
    const auto most = static_cast<int>(diagnosis::SetPolicy{}.max_effects);
    if (choice.together < 1 || choice.together > most)
        return Error{"a diagnosis names 1 to " + std::to_string(most) + " effects", "--together"};
    if (const std::size_t held = ids_of(choice).size(); static_cast<std::size_t>(choice.together) > held)
        return Error{std::to_string(choice.together) + " effects cannot be drawn from " + std::to_string(held),
                     "--together"};
    return {};
}

CaseKind kind_of(int number) {
    const int place = number % round_length;
    return place == 0 ? CaseKind::none : place == deleted_at ? CaseKind::deleted : CaseKind::named;
}

bool may_have_muscles(BodyFamily family) { return family == BodyFamily::beam || family == BodyFamily::tail; }

std::vector<std::string> effects_of(const CaseChoice& choice, int number, int attempt) {
    if (kind_of(number) == CaseKind::none) return {};
    std::vector<std::string> drawn{effect_of(choice, number)}, ids = ids_of(choice);
    if (choice.together < 2 || kind_of(number) != CaseKind::named) return drawn;
    RandomStream random{choice.seed, further_effects, static_cast<std::uint64_t>(number),
                        static_cast<std::uint64_t>(attempt)};
    shuffle(ids, random);
    effect::EffectNeeds needs = effect_draw(drawn.front()).needs;
    for (const std::string& id : ids) {
        if (static_cast<int>(drawn.size()) >= choice.together) break;
        const effect::EffectNeeds more = both(needs, effect_draw(id).needs);
        // The truth has one clamp, which one effect shortens.
        const bool clamped_twice = shortens_clamp(id) && std::any_of(drawn.begin(), drawn.end(), shortens_clamp);
        if (id == drawn.front() || clamped_twice || !can_show(choice, more)) continue;
        drawn.push_back(id);
        needs = more;
    }
    return drawn;
}

effect::EffectNeeds needs_of(const std::vector<std::string>& effects) {
    effect::EffectNeeds needs;
    for (const std::string& id : effects) needs = both(needs, effect_draw(id).needs);
    return needs;
}

BodyFamily drawn_family(const CaseChoice& choice, const effect::EffectNeeds& needs, RandomStream& random) {
    std::vector<BodyFamily> fitting;
    for (const BodyFamily family : families_of(choice, needs))
        if (fits(family, needs)) fitting.push_back(family);
    assert(!fitting.empty());
    return fitting[static_cast<std::size_t>(random.below(static_cast<int>(fitting.size())))];
}

}  // namespace myo::validation
