package enlightenment.world.parts;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.material.Material;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.scene.SceneObject;
import enlightenment.world.material.FaceMaterials;
import enlightenment.world.material.SurfaceMaterial;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

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
public record CompiledPrimitives(
        Primitive[] primitives,
        FaceMaterials materials,
        int[] kind,
        List<String> kindNames,
        int[] glassSolids,
        int[] object,
        int objects,
        int[] mediumRank) {

    /** Turns a shape into primitives: one, or several that are its parts. */
    public interface Placement {
        List<Primitive> place(Shape shape, SceneFrame frame);
    }

    /**
     * @param poll called regularly; what it throws ends this
     */
    public static CompiledPrimitives of(
            List<SceneObject> objects,
            SceneFrame frame,
            Map<Material, SurfaceMaterial> surfaces,
            Placement placement,
            Runnable poll) {
        PlacedObjects placed = new PlacedObjects(objects.size(), surfaces);
        for (int i = 0; i < objects.size(); i++) {
            if (CancellationCheck.isDue(i)) {
                poll.run();
            }
            SceneObject o = objects.get(i);
            placed.add(i, o, place(o, surfaces.get(o.material()), frame, placement));
        }
        return of(placed, placed.canonicalOrder(), objects.size());
    }

    private static List<Primitive> place(
            SceneObject object, SurfaceMaterial surface, SceneFrame frame, Placement placement) {
        if (!(object.shape() instanceof Mesh mesh)) {
            return placement.place(object.shape(), frame);
        }
        if (surface.glows) {
            return Primitives.triangles(mesh, frame);
        }
        return placement.place(surface.any(m -> m.isGlass) ? mesh.outwards() : mesh, frame);
    }

    private static CompiledPrimitives of(PlacedObjects placed, int[] order, int objects) {
        Primitive[] primitives = new Primitive[order.length];
        int[] object = new int[order.length];
        int[] kind = new int[order.length];
        int[] kindRanks = placed.kindRanks();
        for (int id = 0; id < order.length; id++) {
            primitives[id] = placed.primitive(order[id]);
            object[id] = placed.object(order[id]);
            kind[id] = kindRanks[placed.kind(order[id])];
        }
        FaceMaterials materials = new FaceMaterials(order.length, id -> placed.surfaces(order[id]));
        int[] glass = glassSolids(primitives, materials);
        return new CompiledPrimitives(
                primitives,
                materials,
                kind,
                placed.kindNames(),
                glass,
                object,
                objects,
                ranks(primitives, materials, glass));
    }

    private static int[] glassSolids(Primitive[] primitives, FaceMaterials materials) {
        int[] glass = new int[primitives.length];
        int n = 0;
        for (int i = 0; i < primitives.length; i++) {
            if (materials.inside(i).isGlass && primitives[i].isSolid()) {
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
                Comparator.<Integer>comparingInt(i -> -materials.inside(i).priority)
                        .thenComparingDouble(i -> primitives[i].volume())
                        .thenComparingInt(i -> i));
        int[] rank = new int[primitives.length];
        for (int k = 0; k < order.length; k++) {
            rank[order[k]] = k;
        }
        return rank;
    }
}
