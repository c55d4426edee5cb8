package enlightenment.world.light;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.CompiledPrimitives;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * The specular casters of a scene: mirrors, glass, and rough surfaces with narrow lobes, as a few balls around them at which light paths
 * for caustics are aimed.
 */
public final class SpecularCasters {
    /** The centres and radii of the balls, in the frame. */
    final double[] x;

    final double[] y;
    final double[] z;
    final double[] radius;

    /** By ball: whether a mirror or glass is in it. */
    final boolean[] isSharp;

    private SpecularCasters(List<Group> groups) {
        isSharp = new boolean[groups.size()];
        for (int k = 0; k < isSharp.length; k++) {
            isSharp[k] = groups.get(k).isSharp;
        }
        x = groups.stream().mapToDouble(g -> g.center.x()).toArray();
        y = groups.stream().mapToDouble(g -> g.center.y()).toArray();
        z = groups.stream().mapToDouble(g -> g.center.z()).toArray();
        radius = groups.stream().mapToDouble(g -> g.radius).toArray();
    }

    int count() {
        return radius.length;
    }

    /**
     * The casters of a scene.
     *
     * @param most the largest number of balls: of more casters, adjacent ones share a ball
     * @param withSharp whether mirrors and glass are included
     * @param withNarrow whether surfaces with narrow lobes are included
     */
    static SpecularCasters of(CompiledPrimitives compiled, int most, boolean withSharp, boolean withNarrow) {
        int n = compiled.primitives().length;
        int[] wanted = new int[n];
        boolean[] sharp = new boolean[n];
        int count = 0;
        for (int id = 0; id < n; id++) {
            sharp[id] = hasFace(compiled, id, SpecularCasters::isSharp);
            if (withSharp && sharp[id] || withNarrow && hasFace(compiled, id, SpecularCasters::isNarrow)) {
                wanted[count++] = id;
            }
        }
        List<Group> groups = new ArrayList<>();
        if (count > 0) {
            split(compiled.primitives(), sharp, Arrays.copyOf(wanted, count), most, groups);
        }
        return new SpecularCasters(groups);
    }

    private static boolean hasFace(CompiledPrimitives compiled, int id, Predicate<SurfaceMaterial> such) {
        for (int face = 0; face < compiled.primitives()[id].faceCount(); face++) {
            if (compiled.materials().of(id, face).any(such)) {
                return true;
            }
        }
        return false;
    }

    public static boolean isNarrow(SurfaceMaterial material) {
        return material.bsdf.isNarrow() && !material.isBlack;
    }

    /** Whether a material is glass that refracts, or has a delta lobe. */
    public static boolean isSharp(SurfaceMaterial material) {
        boolean turns = material.medium == null || material.indexOfRefraction != 1;
        return material.isGlass && turns || !material.isGlass && material.bsdf.hasDelta() && !material.isBlack;
    }

    /** Splits primitives into halves along the longer side of their box, until there are enough groups. */
    private static void split(Primitive[] all, boolean[] sharp, int[] ids, int most, List<Group> groups) {
        if (ids.length == 1 || most == 1) {
            groups.add(Group.of(all, sharp, ids));
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
        split(all, sharp, Arrays.copyOf(sorted, middle), most / 2, groups);
        split(all, sharp, Arrays.copyOfRange(sorted, middle, sorted.length), most - most / 2, groups);
    }

    private static Bounds box(Primitive[] all, int[] ids) {
        Bounds box = all[ids[0]].bounds();
        for (int id : ids) {
            box = box.union(all[id].bounds());
        }
        return box;
    }

    private record Group(Vec3 center, double radius, boolean isSharp) {
        static Group of(Primitive[] all, boolean[] sharp, int[] ids) {
            boolean isSharp = Arrays.stream(ids).anyMatch(id -> sharp[id]);
            if (ids.length == 1 && all[ids[0]] instanceof SpherePrimitive s) {
                return new Group(s.center(), s.radius(), isSharp);
            }
            Bounds box = box(all, ids);
            return new Group(box.center(), box.extent().length() / 2, isSharp);
        }
    }
}
