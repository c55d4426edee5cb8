package enlightenment.compiled;

import enlightenment.material.Material;
import enlightenment.primitive.Primitive;
import enlightenment.scene.SceneObject;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The primitives of a scene's objects in the order of the file, on their way to the canonical one. */
final class PlacedObjects {
    private final List<SceneObject> objects;
    private final Map<Material, SurfaceMaterial> bySource;
    private Primitive[] primitives;
    private int[] object;
    private int size;

    PlacedObjects(List<SceneObject> objects, Map<Material, SurfaceMaterial> bySource) {
        this.objects = objects;
        this.bySource = bySource;
        primitives = new Primitive[objects.size()];
        object = new int[objects.size()];
    }

    /** Adds the primitives that an object consists of. */
    void add(int index, List<Primitive> parts) {
        for (Primitive p : parts) {
            if (size == object.length) {
                primitives = Arrays.copyOf(primitives, 2 * size + 1);
                object = Arrays.copyOf(object, 2 * size + 1);
            }
            primitives[size] = p;
            object[size++] = index;
        }
    }

    Primitive primitive(int i) {
        return primitives[i];
    }

    /** The index of the object that a primitive is part of. */
    int object(int i) {
        return object[i];
    }

    /** The number of objects. */
    int objects() {
        return objects.size();
    }

    String type(int i) {
        return objects.get(object[i]).shape().type();
    }

    /** The one material of a primitive, or those of its faces. */
    List<SurfaceMaterial> surfaces(int i) {
        SceneObject o = objects.get(object[i]);
        return o.faces().isEmpty()
                ? List.of(bySource.get(o.material()))
                : o.faces().stream().map(bySource::get).toList();
    }

    /**
     * The primitives in an order that depends neither on names nor on the order in the file: by kind, then parameters, then
     * material. Of several with exactly the same surface there is only the first: the others would only shine through by
     * rounding.
     */
    int[] canonicalOrder() {
        int[] order = new int[size];
        int n = 0;
        for (int[] ofKind : byKind()) {
            double[] first = new double[ofKind.length];
            for (int k = 0; k < first.length; k++) {
                first[k] = primitives[ofKind[k]].parameters()[0];
            }
            // Few primitives share their first number, so that the others are hardly ever looked at.
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
        Map<String, int[]> counts = new TreeMap<>();
        for (int i = 0; i < size; i++) {
            counts.computeIfAbsent(type(i), t -> new int[1])[0]++;
        }
        counts.replaceAll((type, count) -> new int[count[0]]);
        Map<String, int[]> filled = new TreeMap<>();
        for (int i = 0; i < size; i++) {
            String type = type(i);
            counts.get(type)[filled.computeIfAbsent(type, t -> new int[1])[0]++] = i;
        }
        return counts.values().toArray(int[][]::new);
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
        /** Of two surfaces in the same place, an opaque one hides one of glass. */
        static final Comparator<Entry> CANONICAL = Comparator.comparing(Entry::parameters, Arrays::compare)
                .thenComparing(Entry::isGlass)
                .thenComparing(Entry::appearance);

        boolean isSameSurface(Entry o) {
            return form == o.form && Arrays.equals(parameters, o.parameters);
        }

        private boolean isGlass() {
            return surfaces.stream().anyMatch(s -> s.isGlass);
        }

        private String appearance() {
            return surfaces.stream().map(SurfaceMaterial::appearance).collect(Collectors.joining(", "));
        }
    }
}
