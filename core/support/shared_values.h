#pragma once

#include <cstddef>
#include <memory>
#include <utility>

namespace esm {

/// Whether both hold the same value, or none.
template<class Value>
bool sameValue(const std::shared_ptr<const Value>& a, const std::shared_ptr<const Value>& b) {
    return a.get() == b.get() || (a && b && *a == *b);
}

/// A shared value that is compared by what it is. Others are compared by where they lie: for large ones that
/// are replaced as a whole, as meshes and photos, that is enough.
template<class Value> struct ByValue : std::shared_ptr<const Value> {
    using std::shared_ptr<const Value>::shared_ptr;
    ByValue(std::shared_ptr<const Value> value) : std::shared_ptr<const Value>(std::move(value)) {}

    friend bool operator==(const ByValue& a, const ByValue& b) { return sameValue<Value>(a, b); }
    friend bool operator==(const ByValue& a, const std::shared_ptr<const Value>& b) {
        return sameValue<Value>(a, b);
    }
    friend bool operator==(const ByValue& a, std::nullptr_t) { return !a; }
};

/// What is made of the rest of the struct that holds it, and kept: it makes no two of them differ.
template<class Value> struct Derived : std::shared_ptr<const Value> {
    using std::shared_ptr<const Value>::shared_ptr;
    Derived(std::shared_ptr<const Value> value) : std::shared_ptr<const Value>(std::move(value)) {}

    friend bool operator==(const Derived&, const Derived&) { return true; }
    friend bool operator==(const Derived& a, std::nullptr_t) { return !a; }
};

} // namespace esm
