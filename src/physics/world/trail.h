// Trails: rows that grow at one end and are forgotten from the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

namespace physics {

// As std::deque, but in blocks that begin small and hold many items: a short trail is one stretch of memory, and a long one
// grows without its items being moved.
template <typename Item>
class Trail {
    // An item by its index; valid as long as no item before it is forgotten.
    template <typename Owner, typename Value>
    class Place {
    public:
        using iterator_category = std::random_access_iterator_tag;
        using value_type = Item;
        using difference_type = std::ptrdiff_t;
        using pointer = Value*;
        using reference = Value&;

        Place() = default;
        Place(Owner* owner, std::ptrdiff_t index) : owner_(owner), index_(index) {}
        operator Place<Trail const, Item const>() const { return {owner_, index_}; }

        reference operator*() const { return (*owner_)[static_cast<std::size_t>(index_)]; }
        pointer operator->() const { return &**this; }
        reference operator[](difference_type n) const { return *(*this + n); }
        Place& operator++() { return *this += 1; }
        Place& operator--() { return *this += -1; }
        Place operator++(int) { return std::exchange(*this, *this + 1); }
        Place operator--(int) { return std::exchange(*this, *this - 1); }
        Place& operator+=(difference_type n) {
            index_ += n;
            return *this;
        }
        Place& operator-=(difference_type n) { return *this += -n; }
        friend Place operator+(Place place, difference_type n) { return place += n; }
        friend Place operator+(difference_type n, Place place) { return place += n; }
        friend Place operator-(Place place, difference_type n) { return place -= n; }
        friend difference_type operator-(Place const& a, Place const& b) { return a.index_ - b.index_; }
        friend bool operator==(Place const& a, Place const& b) { return a.index_ == b.index_; }
        friend auto operator<=>(Place const& a, Place const& b) { return a.index_ <=> b.index_; }

    private:
        Owner* owner_ = nullptr;
        std::ptrdiff_t index_ = 0;
    };

public:
    using value_type = Item;
    using iterator = Place<Trail, Item>;
    using const_iterator = Place<Trail const, Item const>;

    Trail() = default;
    Trail(std::initializer_list<Item> items) {
        for (Item const& item : items) push_back(item);
    }
    Trail(Trail const&) = default;
    Trail(Trail&& other) noexcept : blocks_(std::move(other.blocks_)), forgotten_(std::exchange(other.forgotten_, 0)) {}
    Trail& operator=(Trail other) noexcept {
        blocks_.swap(other.blocks_);
        std::swap(forgotten_, other.forgotten_);
        return *this;
    }
    ~Trail() = default;

    iterator begin() { return {this, 0}; }
    iterator end() { return {this, static_cast<std::ptrdiff_t>(size())}; }
    const_iterator begin() const { return {this, 0}; }
    const_iterator end() const { return {this, static_cast<std::ptrdiff_t>(size())}; }
    std::size_t size() const {
        return blocks_.empty() ? 0 : (blocks_.size() - 1) * block_size + blocks_.back().size() - forgotten_;
    }
    bool empty() const { return size() == 0; }
    Item& operator[](std::size_t i) { return blocks_[(forgotten_ + i) / block_size][(forgotten_ + i) % block_size]; }
    Item const& operator[](std::size_t i) const {
        return blocks_[(forgotten_ + i) / block_size][(forgotten_ + i) % block_size];
    }
    Item& front() { return blocks_.front()[forgotten_]; }
    Item const& front() const { return blocks_.front()[forgotten_]; }
    Item& back() { return blocks_.back().back(); }
    Item const& back() const { return blocks_.back().back(); }

    void push_back(Item const& item) {
        if (blocks_.empty()) blocks_.emplace_back();
        if (blocks_.back().size() == block_size) blocks_.emplace_back().reserve(block_size);
        blocks_.back().push_back(item);
    }
    void pop_back() {
        blocks_.back().pop_back();
        if (blocks_.back().empty() && blocks_.size() > 1) blocks_.pop_back();
        if (empty()) clear();
    }
    // In time that grows with what comes after.
    void insert(const_iterator place, Item const& item) {
        std::ptrdiff_t const index = place - begin();
        push_back(item);
        std::rotate(begin() + index, end() - 1, end());
    }
    // What comes from `first` on.
    void cut(const_iterator first) {
        for (std::ptrdiff_t rest = std::as_const(*this).end() - first; rest > 0; --rest) pop_back();
    }
    void clear() {
        blocks_.resize(std::min<std::size_t>(blocks_.size(), 1));
        if (!blocks_.empty()) blocks_.front().clear();
        forgotten_ = 0;
    }

    // Forgets what lies before `first`. The memory is used again: that of the only block once a good part of it is
    // forgotten, so that each item is moved a few times at most, and else that of whole blocks.
    void forget_before(const_iterator first) {
        forgotten_ += static_cast<std::size_t>(first - begin());
        if (std::size_t const whole = forgotten_ / block_size; whole > 0) {
            blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(std::min(whole, blocks_.size())));
            forgotten_ -= whole * block_size;
        }
        if (blocks_.size() != 1 || forgotten_ * most_forgotten < blocks_.front().size()) return;
        std::vector<Item>& only = blocks_.front();
        only.erase(only.begin(), only.begin() + static_cast<std::ptrdiff_t>(forgotten_));
        forgotten_ = 0;
    }
    void pop_front() { forget_before(std::as_const(*this).begin() + 1); }

private:
    static constexpr std::size_t block_size = 256;
    static constexpr std::size_t most_forgotten = 4;  // one item in so many

    std::vector<std::vector<Item>> blocks_;  // all but the last of block_size items
    std::size_t forgotten_ = 0;              // of the first block
};

}  // namespace physics
