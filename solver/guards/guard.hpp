/// A number by which a run can be believed or not: what it is, what it may be, and what becomes of a
/// run that is beyond it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace crawford {

/// What is said of a number beyond its limit.
enum class Beyond {
    nothing,  ///< it is within, or no more than told
    remark,   ///< the answer is inaccurate, or means something else than it seems to
    refusal   ///< the numbers are proven unstable, or there is no answer
};

struct Guard {
    std::string name;
    double value = 0.0;
    std::optional<double> limit = std::nullopt;  ///< none, where it only tells
    bool is_least = false;                       ///< the value has to be above the limit
    Beyond beyond = Beyond::nothing;
    std::string text = "";  ///< what it means beyond the limit, and what to do
    /// [s] That it allows, where a shorter step helps: \see advise_step.
    std::optional<double> longest_step = std::nullopt;
};

using Guards = std::vector<Guard>;

/// "NAME = VALUE, limit LIMIT: TEXT"
std::string in_words(const Guard& guard);

/// Advises the step that all allow which are beyond their limit: who takes the advice of one must
/// not meet the next.
void advise_step(Guards& guards);

/// Whether `a` is further beyond its limit than `b` of the same name, or nearer to it.
bool is_worse(const Guard& a, const Guard& b);

/// Those that are to be remarked.
Guards remarks(const Guards& guards);

/// \throws InputError in the words of the first that is refused.
void refuse(const Guards& guards);

}  // namespace crawford
