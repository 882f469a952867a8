// Trails: rows that grow at one end and are forgotten from the other, in one stretch of memory that is used again.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace physics {

// As std::deque, but without a piece of memory for every few items. Growing moves the items.
template <typename Item>
class Trail {
public:
    Trail() = default;
    Trail(std::initializer_list<Item> items) : items_(items) {}
    // What is forgotten is not copied.
    Trail(Trail const& other) : items_(other.begin(), other.end()) {}
    Trail(Trail&& other) noexcept : items_(std::move(other.items_)), forgotten_(std::exchange(other.forgotten_, 0)) {}
    Trail& operator=(Trail other) noexcept {
        items_.swap(other.items_);
        std::swap(forgotten_, other.forgotten_);
        return *this;
    }
    ~Trail() = default;

    auto begin() { return items_.begin() + offset(); }
    auto end() { return items_.end(); }
    auto begin() const { return items_.begin() + offset(); }
    auto end() const { return items_.end(); }
    std::size_t size() const { return items_.size() - forgotten_; }
    bool empty() const { return items_.size() == forgotten_; }
    Item& operator[](std::size_t i) { return items_[forgotten_ + i]; }
    Item const& operator[](std::size_t i) const { return items_[forgotten_ + i]; }
    Item& front() { return items_[forgotten_]; }
    Item const& front() const { return items_[forgotten_]; }
    Item& back() { return items_.back(); }
    Item const& back() const { return items_.back(); }

    void push_back(Item const& item) { items_.push_back(item); }
    void push_back(Item&& item) { items_.push_back(std::move(item)); }
    void pop_back() { items_.pop_back(); }
    auto insert(typename std::vector<Item>::const_iterator place, Item item) {
        return items_.insert(place, std::move(item));
    }
    auto erase(typename std::vector<Item>::const_iterator first, typename std::vector<Item>::const_iterator last) {
        return items_.erase(first, last);
    }
    void clear() {
        items_.clear();
        forgotten_ = 0;
    }

    // Forgets what lies before `first`. The memory is used again once it is a good part of the whole, so that each item
    // is moved a few times at most.
    void forget_before(typename std::vector<Item>::const_iterator first) {
        if (first == begin()) return;
        forgotten_ = static_cast<std::size_t>(first - items_.begin());
        if (forgotten_ * most_forgotten < items_.size()) return;
        items_.erase(items_.begin(), begin());
        forgotten_ = 0;
    }
    void pop_front() { forget_before(begin() + 1); }

private:
    static constexpr std::size_t most_forgotten = 4;  // one item in so many

    std::ptrdiff_t offset() const { return static_cast<std::ptrdiff_t>(forgotten_); }

    std::vector<Item> items_;
    std::size_t forgotten_ = 0;
};

}  // namespace physics
