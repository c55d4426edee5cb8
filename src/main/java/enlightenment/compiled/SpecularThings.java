package enlightenment.compiled;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SpherePrimitive;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** The mirrors and the glass of a scene as a few balls around them: what a path from a light that may make a caustic is aimed at. */
final class SpecularThings {
    /** The balls, by their centres and radii. */
    final double[] x;

    final double[] y;
    final double[] z;
    final double[] radius;

    private SpecularThings(List<Group> groups) {
        x = groups.stream().mapToDouble(g -> g.center.x()).toArray();
        y = groups.stream().mapToDouble(g -> g.center.y()).toArray();
        z = groups.stream().mapToDouble(g -> g.center.z()).toArray();
        radius = groups.stream().mapToDouble(g -> g.radius).toArray();
    }

    int count() {
        return radius.length;
    }

    /**
     * The things of a scene.
     *
     * @param most with more of them than this, those near each other share a ball
     */
    static SpecularThings of(CompiledPrimitives compiled, int most) {
        Primitive[] all = compiled.primitives();
        int[] specular = new int[all.length];
        int n = 0;
        for (int id = 0; id < all.length; id++) {
            if (isSpecular(compiled, id)) {
                specular[n++] = id;
            }
        }
        List<Group> groups = new ArrayList<>();
        if (n > 0) {
            split(all, Arrays.copyOf(specular, n), most, groups);
        }
        return new SpecularThings(groups);
    }

    /** Whether any of its faces is of glass, or scatters light into single directions only; not borders that turn no ray. */
    private static boolean isSpecular(CompiledPrimitives compiled, int id) {
        for (int face = 0; face < compiled.primitives()[id].faceCount(); face++) {
            SurfaceMaterial material = compiled.materials().of(id, face);
            boolean turns = material.medium == null || material.indexOfRefraction != 1;
            if (material.isGlass && turns || !material.isGlass && material.isDelta && !material.isBlack) {
                return true;
            }
        }
        return false;
    }

    /** Halves the primitives, by their places along the longer side of their box, until there are groups enough. */
    private static void split(Primitive[] all, int[] ids, int most, List<Group> groups) {
        if (ids.length == 1 || most == 1) {
            groups.add(Group.of(all, ids));
            return;
        }
        Vec3 extent = box(all, ids).extent();
        boolean alongX = extent.x() >= extent.y() && extent.x() >= extent.z();
        boolean alongY = !alongX && extent.y() >= extent.z();
        int[] sorted = Arrays.stream(ids)
                .boxed()
                .sorted(Comparator.<Integer>comparingDouble(id -> {
                            Vec3 c = all[id].bounds().center();
                            return alongX ? c.x() : alongY ? c.y() : c.z();
                        })
                        .thenComparingInt(id -> id))
                .mapToInt(id -> id)
                .toArray();
        int middle = sorted.length / 2;
        split(all, Arrays.copyOf(sorted, middle), most / 2, groups);
        split(all, Arrays.copyOfRange(sorted, middle, sorted.length), most - most / 2, groups);
    }

    private static Bounds box(Primitive[] all, int[] ids) {
        Bounds box = all[ids[0]].bounds();
        for (int id : ids) {
            box = box.union(all[id].bounds());
        }
        return box;
    }

    private record Group(Vec3 center, double radius) {
        static Group of(Primitive[] all, int[] ids) {
            if (ids.length == 1 && all[ids[0]] instanceof SpherePrimitive s) {
                return new Group(s.center(), s.radius());
            }
            Bounds box = box(all, ids);
            return new Group(box.center(), box.extent().length() / 2);
        }
    }
}
