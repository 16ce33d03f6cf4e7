#include "base/cancellation.hpp"

#include <utility>

namespace myo {
namespace {

thread_local const Progress* in_scope = nullptr;

}  // namespace

CancellationScope::CancellationScope(const Progress* progress) : before_(std::exchange(in_scope, progress)) {}

CancellationScope::~CancellationScope() { in_scope = before_; }

const Progress* cancellation_in_scope() { return in_scope; }

bool cancellation_requested() { return in_scope != nullptr && in_scope->cancelled(); }

}  // namespace myo
