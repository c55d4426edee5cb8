package enlightenment.compiled;

import enlightenment.frame.SceneFrame;
import enlightenment.material.Material;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.scene.SceneObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The objects of a scene as primitives in canonical order, with their materials.
 *
 * @param primitives the primitives by id
 * @param materials the materials by id and face
 * @param kind by id: index into {@code kindNames}
 * @param kindNames the kinds of shapes in the scene
 * @param glassSolids ids of solids made of glass
 * @param object by id: the index of its object in the scene's list
 * @param objects the number of objects in the scene's list, duplicates included
 * @param mediumRank by id: rank among the glass solids, the smallest fills overlaps; empty if there is no glass
 */
record CompiledPrimitives(
        Primitive[] primitives,
        FaceMaterials materials,
        int[] kind,
        List<String> kindNames,
        int[] glassSolids,
        int[] object,
        int objects,
        int[] mediumRank) {

    private record Entry(
            int index, SceneObject object, Primitive primitive, double[] parameters, List<SurfaceMaterial> surfaces) {}

    /** By kind, then parameters, then material: nothing that depends on names or on the order in the file. */
    private static final class Canonical implements Comparator<Entry> {
        @Override
        public int compare(Entry a, Entry b) {
            int byKind = a.object.shape().type().compareTo(b.object.shape().type());
            if (byKind != 0) {
                return byKind;
            }
            int byNumbers = Arrays.compare(a.parameters, b.parameters);
            if (byNumbers != 0) {
                return byNumbers;
            }
            // Of two surfaces in the same place, an opaque one hides one of glass.
            int byGlass = Boolean.compare(isGlass(a), isGlass(b));
            return byGlass != 0 ? byGlass : appearance(a).compareTo(appearance(b));
        }

        private static boolean isGlass(Entry e) {
            return e.surfaces.stream().anyMatch(s -> s.isGlass);
        }

        private static String appearance(Entry e) {
            return e.surfaces.stream().map(SurfaceMaterial::appearance).collect(Collectors.joining(", "));
        }
    }

    static CompiledPrimitives of(List<SceneObject> objects, SceneFrame frame, Map<Material, SurfaceMaterial> surfaces) {
        Entry[] entries = new Entry[objects.size()];
        for (int i = 0; i < entries.length; i++) {
            SceneObject o = objects.get(i);
            Primitive p = place(o, i, frame);
            List<SurfaceMaterial> of = o.faces().isEmpty()
                    ? List.of(surfaces.get(o.material()))
                    : o.faces().stream().map(surfaces::get).toList();
            entries[i] = new Entry(i, o, p, p.parameters(), of);
        }
        Arrays.sort(entries, new Canonical());
        return of(withoutDuplicates(entries), objects.size());
    }

    private static CompiledPrimitives of(Entry[] entries, int objects) {
        Primitive[] primitives = Arrays.stream(entries).map(Entry::primitive).toArray(Primitive[]::new);
        FaceMaterials materials =
                new FaceMaterials(Arrays.stream(entries).map(Entry::surfaces).toList());
        List<String> kindNames = new ArrayList<>();
        int[] kind = new int[entries.length];
        for (int i = 0; i < entries.length; i++) {
            String type = entries[i].object.shape().type();
            if (kindNames.isEmpty() || !kindNames.get(kindNames.size() - 1).equals(type)) {
                // Entries are sorted by kind, so each kind is one run.
                kindNames.add(type);
            }
            kind[i] = kindNames.size() - 1;
        }
        int[] glass = glassSolids(primitives, materials);
        int[] object = Arrays.stream(entries).mapToInt(Entry::index).toArray();
        return new CompiledPrimitives(
                primitives, materials, kind, kindNames, glass, object, objects, ranks(primitives, materials, glass));
    }

    /** Throws if one of the objects cannot be placed in the frame. */
    static void check(List<SceneObject> objects, SceneFrame frame) {
        for (int i = 0; i < objects.size(); i++) {
            place(objects.get(i), i, frame);
        }
    }

    /** The primitive of the object at an index; the key of an invalid value becomes relative to the scene. */
    private static Primitive place(SceneObject object, int index, SceneFrame frame) {
        try {
            return Primitives.place(object.shape(), frame);
        } catch (InvalidValueException e) {
            throw new InvalidValueException("objects/" + index + "/" + e.key(), e.problem());
        }
    }

    /** Of several objects with exactly the same surface, the first: the others would only shine through by rounding. */
    private static Entry[] withoutDuplicates(Entry[] sorted) {
        List<Entry> kept = new ArrayList<>(sorted.length);
        Entry last = null;
        for (Entry e : sorted) {
            boolean duplicate = last != null
                    && last.primitive.getClass() == e.primitive.getClass()
                    && last.object.shape().type().equals(e.object.shape().type())
                    && Arrays.equals(last.parameters, e.parameters);
            if (!duplicate) {
                kept.add(e);
                last = e;
            }
        }
        return kept.toArray(Entry[]::new);
    }

    private static int[] glassSolids(Primitive[] primitives, FaceMaterials materials) {
        int[] glass = new int[primitives.length];
        int n = 0;
        for (int i = 0; i < primitives.length; i++) {
            if (primitives[i].isSolid() && materials.of(i, 0).isGlass) {
                glass[n++] = i;
            }
        }
        return Arrays.copyOf(glass, n);
    }

    private static int[] ranks(Primitive[] primitives, FaceMaterials materials, int[] glass) {
        if (glass.length == 0) {
            return new int[0];
        }
        Integer[] order = Arrays.stream(glass).boxed().toArray(Integer[]::new);
        Arrays.sort(
                order,
                Comparator.<Integer>comparingInt(i -> -materials.of(i, 0).priority)
                        .thenComparingDouble(i -> size(primitives[i]))
                        .thenComparingInt(i -> i));
        int[] rank = new int[primitives.length];
        for (int k = 0; k < order.length; k++) {
            rank[order[k]] = k;
        }
        return rank;
    }

    private static double size(Primitive p) {
        Vec3 extent = p.bounds().extent();
        return extent.x() * extent.y() * extent.z();
    }
}
