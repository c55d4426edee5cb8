package enlightenment.importer.pbrt;

import enlightenment.math.Vec3;
import enlightenment.scene.SceneException;
import enlightenment.text.Plain;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The parameters of a directive by name. A missing parameter is absent; one of another type or length is refused at its line. */
final class Parameters {
    private static final Set<String> NUMBERS = Set.of("float", "integer");
    private static final Set<String> TUPLES =
            Set.of("point", "point2", "point3", "vector", "vector2", "vector3", "normal", "normal3", "float");

    private final Map<String, Parameter> byName = new LinkedHashMap<>();
    private final Place place;

    /** @param place of the directive */
    Parameters(Place place) {
        this.place = place;
    }

    Place place() {
        return place;
    }

    /** Adds a parameter; a later one of the same name is refused. */
    void add(Parameter p) {
        if (byName.putIfAbsent(p.name(), p) != null) {
            throw p.place().failure("the parameter " + Plain.quoted(p.name()) + " is given twice");
        }
    }

    /** Adds those that are not here yet. */
    void addDefaults(Iterable<Parameter> defaults) {
        defaults.forEach(p -> byName.putIfAbsent(p.name(), p));
    }

    Iterable<Parameter> all() {
        return byName.values();
    }

    Optional<Parameter> find(String name) {
        return Optional.ofNullable(byName.get(name));
    }

    boolean has(String name) {
        return byName.containsKey(name);
    }

    /** Whether a parameter refers to a texture. */
    boolean isTexture(String name) {
        return has(name) && byName.get(name).type().equals("texture");
    }

    private static SceneException wrong(Parameter p, String expected) {
        return p.place().failure("the parameter " + Plain.quoted(p.type() + " " + p.name()) + " must be " + expected);
    }

    double number(String name, double usual) {
        Parameter p = byName.get(name);
        if (p == null) {
            return usual;
        }
        if (!NUMBERS.contains(p.type()) || p.numbers().length != 1) {
            throw wrong(p, "one number, as \"float " + Plain.excerpt(name) + "\"");
        }
        return p.numbers()[0];
    }

    /** A number that must be greater than 0. */
    double positive(String name, double usual) {
        double v = number(name, usual);
        if (!(v > 0)) {
            throw wrong(byName.get(name), "greater than 0, not " + v);
        }
        return v;
    }

    int integer(String name, int usual, int least, int most) {
        Parameter p = byName.get(name);
        if (p == null) {
            return usual;
        }
        double v = p.type().equals("integer") && p.numbers().length == 1 ? p.numbers()[0] : Double.NaN;
        if (v != (int) v || v < least || v > most) {
            throw wrong(p, "one whole number in " + least + ".." + most);
        }
        return (int) v;
    }

    boolean isTrue(String name, boolean usual) {
        Parameter p = byName.get(name);
        if (p == null) {
            return usual;
        }
        String word =
                p.type().equals("bool") && p.words().size() == 1 ? p.words().get(0) : "";
        if (!word.equals("true") && !word.equals("false")) {
            throw wrong(p, "true or false");
        }
        return word.equals("true");
    }

    String string(String name, String usual) {
        Parameter p = byName.get(name);
        if (p == null) {
            return usual;
        }
        if (p.words().size() != 1 || !p.type().equals("string") && !p.type().equals("texture")) {
            throw wrong(p, "one string");
        }
        return p.words().get(0);
    }

    List<String> strings(String name) {
        Parameter p = byName.get(name);
        if (p == null) {
            return List.of();
        }
        if (!p.type().equals("string") || p.numbers().length > 0) {
            throw wrong(p, "strings");
        }
        return p.words();
    }

    Vec3 vector(String name, Vec3 usual) {
        Parameter p = byName.get(name);
        if (p == null) {
            return usual;
        }
        double[] v = tuples(name, 3);
        if (v.length != 3) {
            throw wrong(p, "three numbers");
        }
        return new Vec3(v[0], v[1], v[2]);
    }

    /**
     * Points, vectors or normals.
     *
     * @param each the numbers of one
     * @return empty if the parameter is absent
     */
    double[] tuples(String name, int each) {
        Parameter p = byName.get(name);
        if (p == null) {
            return new double[0];
        }
        if (!TUPLES.contains(p.type())
                || p.numbers().length % each != 0
                || !p.words().isEmpty()) {
            throw wrong(p, "numbers, " + each + " for each " + (each == 2 ? "pair" : "point"));
        }
        return p.numbers();
    }

    /** Whole numbers from 0 on; empty if the parameter is absent. */
    int[] integers(String name) {
        Parameter p = byName.get(name);
        if (p == null) {
            return new int[0];
        }
        int[] values = new int[p.numbers().length];
        for (int i = 0; i < values.length; i++) {
            values[i] = (int) p.numbers()[i];
            if (!p.type().equals("integer") || values[i] != p.numbers()[i]) {
                throw wrong(p, "whole numbers");
            }
        }
        return values;
    }
}
