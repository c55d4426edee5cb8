package enlightenment.importer.mitsuba;

import enlightenment.importer.support.Affine;
import enlightenment.math.Vec3;
import enlightenment.text.Plain;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** The properties of a plugin by name; remembers which were asked for, so that the others can be noted. */
final class Properties {
    private static final Set<String> VALUES = Set.of(
            "float",
            "integer",
            "boolean",
            "string",
            "vector",
            "point",
            "transform",
            "rgb",
            "srgb",
            "spectrum",
            "blackbody",
            "ref",
            "texture");

    private final XmlElement element;
    private final Set<String> known = new HashSet<>();

    Properties(XmlElement element) {
        this.element = element;
    }

    XmlElement element() {
        return element;
    }

    /** A property's element. */
    Optional<XmlElement> find(String name) {
        known.add(name);
        return element.children().stream().filter(c -> c.name().equals(name)).findFirst();
    }

    boolean has(String name) {
        return find(name).isPresent();
    }

    /** Marks properties as known that change nothing here. */
    void ignore(String... names) {
        known.addAll(List.of(names));
    }

    /** Marks all properties as known: the plugin is left out. */
    void ignoreAll() {
        element.children().forEach(c -> known.add(c.name()));
    }

    /** The properties with names that nothing asked for. */
    Stream<XmlElement> unused() {
        return element.children().stream()
                .filter(c -> VALUES.contains(c.tag()))
                .filter(c -> !c.name().isEmpty() && !known.contains(c.name()));
    }

    double number(String name, double otherwise) {
        return find(name).map(e -> number(e, e.attribute("value"))).orElse(otherwise);
    }

    int whole(String name, int otherwise) {
        Optional<XmlElement> e = find(name);
        if (e.isEmpty()) {
            return otherwise;
        }
        double v = number(e.get(), e.get().attribute("value"));
        if (v != StrictMath.rint(v) || StrictMath.abs(v) > Integer.MAX_VALUE) {
            throw e.get()
                    .failure("must be a whole number, not "
                            + Plain.quoted(e.get().attribute("value")));
        }
        return (int) v;
    }

    boolean flag(String name, boolean otherwise) {
        Optional<XmlElement> e = find(name);
        if (e.isEmpty()) {
            return otherwise;
        }
        return switch (e.get().attribute("value").strip().toLowerCase(java.util.Locale.ROOT)) {
            case "true" -> true;
            case "false" -> false;
            default ->
                throw e.get()
                        .failure("must be true or false, not "
                                + Plain.quoted(e.get().attribute("value")));
        };
    }

    String text(String name, String otherwise) {
        return find(name).map(e -> e.attribute("value")).orElse(otherwise);
    }

    Vec3 point(String name, Vec3 otherwise) {
        return find(name).map(Properties::vector).orElse(otherwise);
    }

    Affine transform(String name) {
        return find(name).map(TransformElement::map).orElse(Affine.IDENTITY);
    }

    /** The elements inside that are no values: nested plugins and references, with these tags. */
    List<XmlElement> nested(String... tags) {
        List<String> wanted = List.of(tags);
        return element.children().stream().filter(c -> wanted.contains(c.tag())).toList();
    }

    /** Three numbers, as {@code x}, {@code y}, {@code z} or in {@code value}; one in {@code value} counts for all. */
    static Vec3 vector(XmlElement e) {
        return vector(e, 0);
    }

    static Vec3 vector(XmlElement e, double otherwise) {
        if (e.has("value")) {
            double[] v = numbers(e, e.attribute("value"));
            if (v.length != 3 && v.length != 1) {
                throw e.failure("must be three numbers, not " + Plain.quoted(e.attribute("value")));
            }
            return new Vec3(v[0], v[v.length - 1 > 0 ? 1 : 0], v[v.length - 1]);
        }
        return new Vec3(
                e.has("x") ? number(e, e.attribute("x")) : otherwise,
                e.has("y") ? number(e, e.attribute("y")) : otherwise,
                e.has("z") ? number(e, e.attribute("z")) : otherwise);
    }

    static double number(XmlElement e, String text) {
        try {
            double v = Double.parseDouble(text.strip());
            if (Double.isFinite(v)) {
                return v;
            }
        } catch (NumberFormatException ignored) {
            // Said below.
        }
        throw e.failure("must be a finite number, not " + Plain.quoted(text));
    }

    /** Numbers that commas or spaces separate. */
    static double[] numbers(XmlElement e, String text) {
        String stripped = text.strip();
        if (stripped.isEmpty()) {
            throw e.failure("must be numbers, not \"\"");
        }
        return Stream.of(stripped.split("[\\s,]+"))
                .mapToDouble(t -> number(e, t))
                .toArray();
    }
}
