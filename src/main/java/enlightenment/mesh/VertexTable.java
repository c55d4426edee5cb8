package enlightenment.mesh;

/** Numbers triples of integers, equal ones with one number: an open-addressed hash table. */
final class VertexTable {
    private final Ints keys = new Ints(12);

    /** By slot: the number of a triple and 1, or 0 if the slot is empty; at most three quarters are full. */
    private int[] slots = new int[8];

    /** The number of a triple; new ones are counted on. */
    int number(int a, int b, int c) {
        int slot = slot(a, b, c);
        while (slots[slot] != 0) {
            int k = 3 * (slots[slot] - 1);
            if (keys.get(k) == a && keys.get(k + 1) == b && keys.get(k + 2) == c) {
                return slots[slot] - 1;
            }
            slot = slot + 1 & slots.length - 1;
        }
        keys.add(a);
        keys.add(b);
        keys.add(c);
        slots[slot] = size();
        if (size() > slots.length / 4 * 3L && slots.length < 1 << 30) {
            grow();
        }
        return size() - 1;
    }

    private void grow() {
        slots = new int[2 * slots.length];
        for (int i = 0; i < size(); i++) {
            int slot = slot(keys.get(3 * i), keys.get(3 * i + 1), keys.get(3 * i + 2));
            while (slots[slot] != 0) {
                slot = slot + 1 & slots.length - 1;
            }
            slots[slot] = i + 1;
        }
    }

    private int slot(int a, int b, int c) {
        long h = (a * 0x9E3779B97F4A7C15L ^ b) * 0xBF58476D1CE4E5B9L;
        h = (h ^ h >>> 32 ^ c) * 0x94D049BB133111EBL;
        return (int) (h ^ h >>> 32) & slots.length - 1;
    }

    int size() {
        return keys.size() / 3;
    }

    /** A part of a triple: 0, 1 or 2. */
    int part(int number, int which) {
        return keys.get(3 * number + which);
    }

    /** Gives the memory of the table back; no more triples can be numbered. */
    void freeze() {
        slots = new int[0];
    }
}
