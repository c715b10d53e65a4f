// Where the candidates of a child lie: the list of its parent, and the child's own words of the masks.

/// The children at hand and their parents' lists; the same for testing and for emitting.
struct Portion {
  uint first_child;  // of the level below
  uint child_count;
  uint first_parent;
  uint parent_count;
  uint first_base;    // element of `bases` that belongs to first_parent
  uint pairs_before;  // value of that element
  uint arity;         // most children of a parent
};

struct List {
  uint begin;  // first pair of the parent
  uint end;
  uint first_mask;  // of this child: a word 32 pairs
};

/// Words are laid out without another scan: a parent whose list begins at b owns (b / 32 + its place) × arity onwards.
List list_of(Portion portion, uint begin, uint end, uint parent_place, uint child_place) {
  uint words = (end - begin + 31u) / 32u;
  return List(begin, end, (begin / 32u + parent_place) * portion.arity + child_place * words);
}
