package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** A list of primitives, each of which is tested: faster than a hierarchy up to about two dozen. */
public final class PrimitiveList implements Accelerator {
    private final Primitive[] primitives;
    private final int[] kinds;
    private final int[] members;
    private int size;

    /** The kinds of the members, and the number of each: a search tests all of them, so they are counted together. */
    private final int[] kindsThere;

    private final int[] numberOfKind;
    private int kindCount;
    private final QuickTests quick;

    private PrimitiveList(Primitive[] primitives, int[] kinds, int size) {
        this.primitives = primitives;
        this.kinds = kinds;
        members = new int[primitives.length];
        kindsThere = new int[primitives.length];
        numberOfKind = new int[primitives.length];
        quick = new QuickTests(primitives.length);
        for (int i = 0; i < size; i++) {
            members[i] = i;
        }
        size(size);
    }

    /**
     * A list of all of these primitives; ids are indices into the array.
     *
     * @param kinds by id: the kind of primitive, for counting tests
     */
    public static PrimitiveList of(Primitive[] primitives, int[] kinds) {
        return new PrimitiveList(primitives, kinds, primitives.length);
    }

    /** An empty list that can be filled, by {@link #members} and {@link #size(int)}, with some of this one's primitives. */
    public PrimitiveList empty() {
        return new PrimitiveList(primitives, kinds, 0);
    }

    /** The ids of the members, then room for as many as there are primitives. */
    public int[] members() {
        return members;
    }

    /** Sets the number of {@link #members} in use. */
    public void size(int count) {
        size = count;
        kindCount = 0;
        for (int k = 0; k < count; k++) {
            countKind(kinds[members[k]]);
        }
        quick.set(primitives, members, count);
    }

    private void countKind(int kind) {
        for (int i = 0; i < kindCount; i++) {
            if (kindsThere[i] == kind) {
                numberOfKind[i]++;
                return;
            }
        }
        kindsThere[kindCount] = kind;
        numberOfKind[kindCount++] = 1;
    }

    /** The number of members. */
    public int size() {
        return size;
    }

    @Override
    public void search(Ray ray, Closest state) {
        if (!quick.search(ray, state)) {
            searchAll(ray, state);
        }
        for (int i = 0; i < kindCount; i++) {
            state.count(kindsThere[i], numberOfKind[i]);
        }
    }

    private void searchAll(Ray ray, Closest state) {
        for (int k = 0; k < size; k++) {
            state.offerCounted(ray, primitives[members[k]], members[k]);
        }
    }

    @Override
    public boolean occluded(Ray ray, double tMax, BvhQuery query) {
        for (int k = 0; k < size; k++) {
            if (query.blocks(primitives[members[k]], members[k], ray, tMax)) {
                return true;
            }
        }
        return false;
    }

    @Override
    public int narrow(BallCone cone, ConeJudge judge, int rays, BvhQuery query) {
        int[] ids = members;
        int n = size;
        query.clear();
        for (int k = 0; k < n; k++) {
            int id = ids[k];
            int verdict = judge.judge(id);
            if (verdict == ConeJudge.BLOCKS_ALL) {
                return BLOCKED;
            }
            if (verdict == ConeJudge.MAY_BLOCK) {
                query.add(id);
            }
        }
        return query.size();
    }

    @Override
    public boolean occludedWithin(Ray ray, double tMax, BvhQuery query) {
        int n = query.size();
        for (int k = 0; k < n; k++) {
            int id = query.get(k);
            if (query.blocks(primitives[id], id, ray, tMax)) {
                return true;
            }
        }
        return false;
    }

    /** Adds all ids: comparing boxes is left to the caller. */
    @Override
    public void overlapping(Bounds box, BvhQuery query) {
        for (int k = 0; k < size; k++) {
            query.add(members[k]);
        }
    }

    @Override
    public Bounds bounds() {
        Bounds all = size == 0 ? Bounds.of(Vec3.ZERO) : primitives[members[0]].bounds();
        for (int k = 1; k < size; k++) {
            all = all.union(primitives[members[k]].bounds());
        }
        return all;
    }
}
