package enlightenment.bvh;

/**
 * The layout of a hierarchy in flat arrays. A node is its two children; {@code child[2n]} and {@code child[2n + 1]} are the links to the
 * children of node n. A link that is not negative is a node; a negative one is a leaf, {@code ~(first place << 3 | number of places)}.
 * Nodes lie in depth-first order, node 0 is the root.
 */
public final class Nodes {
    /** The largest depth of a tree. */
    public static final int MAX_DEPTH = 64;

    /** The numbers of a node: two boxes. */
    public static final int NODE = 12;

    /** A leaf without places: the link of a child that does not exist. */
    public static final int EMPTY = ~0;

    /** A leaf's link has room for places below this. */
    public static final int MOST_ITEMS = 1 << 28;

    private static final int COUNT_BITS = 3;
    private static final int COUNT_MASK = (1 << COUNT_BITS) - 1;

    private Nodes() {}

    /** The link of a leaf. */
    static int leaf(int first, int count) {
        return ~(first << COUNT_BITS | count);
    }

    /** The first place of a leaf. */
    public static int first(int leaf) {
        return ~leaf >>> COUNT_BITS;
    }

    /** The place after the last one of a leaf. */
    public static int end(int leaf) {
        return (~leaf >>> COUNT_BITS) + (~leaf & COUNT_MASK);
    }
}
