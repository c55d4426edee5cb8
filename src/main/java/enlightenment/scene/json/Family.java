package enlightenment.scene.json;

import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;

/**
 * The kinds of a part that {@code "type"} distinguishes, such as those of lights. Each has a name, keys, a reader and a writer.
 *
 * @param <T> common type of the values of all kinds
 */
final class Family<T> {
    private final String name;
    private final String noun;
    private final String typeUnlessGiven;
    private final Map<String, String> plannedTypes;
    private final BiFunction<String, Fields, ? extends T> reader;
    private final BiConsumer<T, JsonObjectBuilder> writer;
    private final Map<String, Keys> byName = new LinkedHashMap<>();
    private final Map<String, Map<String, String>> refused = new HashMap<>();
    private final Map<Class<?>, String> names = new HashMap<>();

    /**
     * @param name the name of the family in the schema's {@code $defs}
     * @param noun the name of a part in messages, with its article
     * @param typeUnlessGiven the default type, or null if a part must have one
     * @param plannedTypes types that the format will have, with the reason why each is missing, or ""
     * @param reader makes the value of a type; null after a problem. One reader serves all types, since a lambda for each type would load a class
     *     of the JDK at start, whether a scene has the type or not
     * @param writer puts all keys of a value but {@code "type"}
     */
    Family(
            String name,
            String noun,
            String typeUnlessGiven,
            Map<String, String> plannedTypes,
            BiFunction<String, Fields, ? extends T> reader,
            BiConsumer<T, JsonObjectBuilder> writer) {
        this.name = name;
        this.noun = noun;
        this.typeUnlessGiven = typeUnlessGiven;
        this.plannedTypes = plannedTypes;
        this.reader = reader;
        this.writer = writer;
    }

    /**
     * Adds a kind.
     *
     * @param type the name of the kind in the format
     * @param value the class of its values
     * @param keys the required keys, a bar, the optional keys
     */
    Family<T> with(String type, Class<? extends T> value, String keys) {
        return with(type, value, keys, Map.of());
    }

    /**
     * Adds a kind that refuses certain keys with a message of their own.
     *
     * @param type the name of the kind in the format
     * @param value the class of its values
     * @param keys the required keys, a bar, the optional keys
     * @param whyNot refused keys that users may expect, with the message for each
     */
    Family<T> with(String type, Class<? extends T> value, String keys, Map<String, String> whyNot) {
        int bar = keys.indexOf('|');
        String required = keys.substring(0, bar);
        String optional = keys.substring(bar + 1);
        boolean implied = type.equals(typeUnlessGiven);
        Keys all = Keys.of(
                type + Character.toUpperCase(name.charAt(0)) + name.substring(1),
                (type.startsWith("i") || type.startsWith("o") ? "an " : "a ") + type + nounSuffix(),
                (implied ? "" : "type ") + required,
                (implied ? "type " : "") + optional);
        byName.put(type, all);
        refused.put(type, whyNot);
        names.put(value, type);
        return this;
    }

    /** The end of a kind's noun: none for shapes ("a sphere"), the family's name for others ("a sphere light"). */
    private String nounSuffix() {
        return name.equals("object") ? "" : " " + name;
    }

    String name() {
        return name;
    }

    String noun() {
        return noun;
    }

    String typeUnlessGiven() {
        return typeUnlessGiven;
    }

    Map<String, String> plannedTypes() {
        return plannedTypes;
    }

    /** The refused keys of a kind, with the message for each. */
    Map<String, String> refusedKeys(String type) {
        return refused.get(type);
    }

    /** The names of all kinds. */
    Collection<String> types() {
        return Collections.unmodifiableSet(byName.keySet());
    }

    /** The keys of each kind. */
    List<Keys> keys() {
        return List.copyOf(byName.values());
    }

    Keys keys(String type) {
        return byName.get(type);
    }

    /** The exception of a reader or writer without a case for a kind. */
    static IllegalStateException unknown(Object kind) {
        return new IllegalStateException("the scene format knows " + kind + ", but not how to read or write it");
    }

    /** The name of the kind whose values have a class; null if there is none. */
    String typeOf(Class<?> value) {
        return names.get(value);
    }

    /** The value of a part whose type is known; null after a problem. */
    T read(Fields f) {
        return reader.apply(f.type(typeUnlessGiven), f);
    }

    /**
     * Puts a value's type, unless that is the default, and its keys.
     *
     * @throws IllegalStateException if no kind has the value's class
     */
    void write(T value, JsonObjectBuilder p) {
        String type = names.get(value.getClass());
        if (type == null) {
            throw new IllegalStateException("the scene format has no " + name + " for "
                    + value.getClass().getName());
        }
        if (!type.equals(typeUnlessGiven)) {
            p.text("type", type);
        }
        writer.accept(value, p);
    }
}
