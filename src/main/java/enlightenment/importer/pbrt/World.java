package enlightenment.importer.pbrt;

import enlightenment.importer.support.Affine;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The shapes of a scene as they stand in the file: alone, or in named objects that have instances. */
final class World {
    /** The most shapes, instances counted. */
    private static final long MOST = 1L << 24;

    /** An instance of a named object. */
    private record Instance(String name, Affine map, Place place) {}

    private final List<ShapeDefinition> alone = new ArrayList<>();
    private final Map<String, List<ShapeDefinition>> objects = new HashMap<>();
    private final List<Instance> instances = new ArrayList<>();

    /** The object that shapes go to; null if they stand alone. */
    private List<ShapeDefinition> open;

    boolean isObjectOpen() {
        return open != null;
    }

    void beginObject(String name, Place place) {
        if (open != null) {
            throw place.failure("an object must not begin inside of an object");
        }
        open = new ArrayList<>();
        if (objects.putIfAbsent(name, open) != null) {
            throw place.failure("the object " + Plain.quoted(name) + " is defined twice");
        }
    }

    void endObject(Place place) {
        if (open == null) {
            throw place.failure("ObjectEnd has no ObjectBegin");
        }
        open = null;
    }

    void add(ShapeDefinition shape) {
        List<ShapeDefinition> to = open == null ? alone : open;
        to.add(shape);
    }

    void addInstance(String name, Affine map, Place place) {
        if (open != null) {
            throw place.failure("an instance must not stand inside of an object");
        }
        instances.add(new Instance(name, map, place));
    }

    /** Takes a shape in its place. */
    interface Visitor {
        /** @param map to the world */
        void visit(ShapeDefinition shape, Affine map);
    }

    /** Visits all shapes, those of instances with their maps. */
    void forEach(Visitor visitor) {
        alone.forEach(s -> visitor.visit(s, s.map()));
        long count = alone.size();
        for (Instance instance : instances) {
            List<ShapeDefinition> shapes = objects.get(instance.name());
            if (shapes == null) {
                throw instance.place().failure("there is no object named " + Plain.quoted(instance.name()));
            }
            count += shapes.size();
            if (count > MOST) {
                throw instance.place().failure("instances make more than " + MOST + " shapes");
            }
            shapes.forEach(s -> visitor.visit(s, instance.map().after(s.map())));
        }
    }
}
