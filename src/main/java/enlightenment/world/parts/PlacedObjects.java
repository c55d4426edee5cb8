package enlightenment.world.parts;

import enlightenment.material.Material;
import enlightenment.primitive.Primitive;
import enlightenment.scene.SceneObject;
import enlightenment.world.material.SurfaceMaterial;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The primitives of a scene's objects in the order of the file, before they are put in canonical order. */
final class PlacedObjects {
    private final Map<Material, SurfaceMaterial> bySource;
    private final Map<String, Integer> kinds = new TreeMap<>();
    private Primitive[] primitives;
    private int[] object;
    private int[] kind;

    /** By primitive: its one material; null for one that has a material for each face ({@link #ofFaces}). */
    private SurfaceMaterial[] surface;

    private final Map<Integer, List<SurfaceMaterial>> ofFaces = new HashMap<>();
    private int size;

    PlacedObjects(int objects, Map<Material, SurfaceMaterial> bySource) {
        this.bySource = bySource;
        primitives = new Primitive[objects];
        object = new int[objects];
        kind = new int[objects];
        surface = new SurfaceMaterial[objects];
    }

    /** Adds the primitives that an object consists of. */
    void add(int index, SceneObject o, List<Primitive> parts) {
        int ofType = kinds.computeIfAbsent(o.shape().type(), t -> kinds.size());
        for (Primitive p : parts) {
            makeRoom();
            primitives[size] = p;
            object[size] = index;
            kind[size] = ofType;
            if (o.faces().isEmpty()) {
                surface[size] = bySource.get(o.material());
            } else {
                ofFaces.put(size, o.faces().stream().map(bySource::get).toList());
            }
            size++;
        }
    }

    private void makeRoom() {
        if (size == object.length) {
            int more = 2 * size + 1;
            primitives = Arrays.copyOf(primitives, more);
            object = Arrays.copyOf(object, more);
            kind = Arrays.copyOf(kind, more);
            surface = Arrays.copyOf(surface, more);
        }
    }

    Primitive primitive(int i) {
        return primitives[i];
    }

    /** The index of the object that a primitive is part of. */
    int object(int i) {
        return object[i];
    }

    /** The kinds of shapes, in alphabetical order. */
    List<String> kindNames() {
        return List.copyOf(kinds.keySet());
    }

    /** By the numbers of {@link #kind}: the rank of the kind in alphabetical order. */
    int[] kindRanks() {
        int[] ranks = new int[kinds.size()];
        int rank = 0;
        for (int k : kinds.values()) {
            ranks[k] = rank++;
        }
        return ranks;
    }

    int kind(int i) {
        return kind[i];
    }

    /** The one material of a primitive, or those of its faces. */
    List<SurfaceMaterial> surfaces(int i) {
        return surface[i] == null ? ofFaces.get(i) : List.of(surface[i]);
    }

    /**
     * The primitives in an order that depends neither on names nor on the order in the file: by kind, then parameters, then material. Of
     * several with exactly the same surface only the first is kept: the others would show only by rounding.
     */
    int[] canonicalOrder() {
        int[] order = new int[size];
        int n = 0;
        for (int[] ofKind : byKind()) {
            double[] first = new double[ofKind.length];
            for (int k = 0; k < first.length; k++) {
                first[k] = primitives[ofKind[k]].firstParameter();
            }
            // Few primitives share their first parameter, so that the others are seldom compared.
            int[] byFirst = Ascending.order(first);
            for (int k = 0; k < byFirst.length; ) {
                int end = k + 1;
                while (end < byFirst.length && Double.compare(first[byFirst[k]], first[byFirst[end]]) == 0) {
                    end++;
                }
                n = end == k + 1 ? add(ofKind[byFirst[k]], order, n) : addRun(ofKind, byFirst, k, end, order, n);
                k = end;
            }
        }
        return Arrays.copyOf(order, n);
    }

    private static int add(int i, int[] order, int n) {
        order[n] = i;
        return n + 1;
    }

    /** The primitives of each kind, the kinds in alphabetical order. */
    private int[][] byKind() {
        int[] ranks = kindRanks();
        int[] counts = new int[ranks.length];
        for (int i = 0; i < size; i++) {
            counts[ranks[kind[i]]]++;
        }
        int[][] byKind = new int[ranks.length][];
        for (int rank = 0; rank < ranks.length; rank++) {
            byKind[rank] = new int[counts[rank]];
        }
        for (int i = size - 1; i >= 0; i--) {
            int rank = ranks[kind[i]];
            byKind[rank][--counts[rank]] = i;
        }
        return byKind;
    }

    /** Adds primitives of one kind that have the same first parameter. */
    private int addRun(int[] ofKind, int[] byFirst, int start, int end, int[] order, int n) {
        Entry[] run = new Entry[end - start];
        for (int k = 0; k < run.length; k++) {
            int i = ofKind[byFirst[start + k]];
            run[k] = new Entry(i, primitives[i].getClass(), primitives[i].parameters(), surfaces(i));
        }
        Arrays.sort(run, Entry.CANONICAL);
        int m = n;
        Entry last = null;
        for (Entry e : run) {
            if (last == null || !last.isSameSurface(e)) {
                m = add(e.index, order, m);
                last = e;
            }
        }
        return m;
    }

    private record Entry(int index, Class<?> form, double[] parameters, List<SurfaceMaterial> surfaces) {
        /** Of two surfaces in the same place, an opaque one hides one of glass, and an emitting one hides others. */
        static final Comparator<Entry> CANONICAL = Comparator.comparing(Entry::parameters, Arrays::compare)
                .thenComparing(Entry::isGlass)
                .thenComparing(e -> !e.glows())
                .thenComparing(Entry::appearance);

        boolean isSameSurface(Entry o) {
            return form == o.form && Arrays.equals(parameters, o.parameters);
        }

        private boolean glows() {
            return surfaces.stream().anyMatch(s -> s.glows);
        }

        private boolean isGlass() {
            return surfaces.stream().anyMatch(s -> s.isGlass);
        }

        private String appearance() {
            return surfaces.stream().map(SurfaceMaterial::appearance).collect(Collectors.joining(", "));
        }
    }
}
