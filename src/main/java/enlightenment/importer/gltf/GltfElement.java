package enlightenment.importer.gltf;

import enlightenment.text.Plain;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * A value of a glTF document that knows where it stands, such as {@code "meshes/3/primitives/0"}. Methods fail with an {@link IOException} that
 * names that place where the document has another kind of value than they return. What is absent has no value.
 */
final class GltfElement {
    private final Object value;
    private final String place;

    GltfElement(Object value, String place) {
        this.value = value;
        this.place = place;
    }

    /** What is absent, with the name that messages give it. */
    static GltfElement absent(String name) {
        return new GltfElement(null, name);
    }

    /** Where it stands; "" for the document. */
    String place() {
        return place;
    }

    boolean isPresent() {
        return value != null;
    }

    IOException failure(String message) {
        return new IOException(place.isEmpty() ? message : place + ": " + message);
    }

    private String placeOf(String key) {
        return place.isEmpty() ? Plain.excerpt(key) : place + "/" + Plain.excerpt(key);
    }

    private Object raw(String key) {
        return value instanceof Map<?, ?> map ? map.get(key) : null;
    }

    boolean has(String key) {
        return raw(key) != null;
    }

    /** The object at a key, without a value if there is none. */
    GltfElement get(String key) throws IOException {
        Object v = raw(key);
        if (v != null && !(v instanceof Map)) {
            throw new IOException(placeOf(key) + ": must be an object");
        }
        return new GltfElement(v, placeOf(key));
    }

    /** An extension of this object, without a value if there is none. */
    GltfElement extension(String name) throws IOException {
        return get("extensions").get(name);
    }

    /** The names of the extensions of this object. */
    Set<String> extensions() throws IOException {
        return get("extensions").keys();
    }

    /** The keys of this object. */
    Set<String> keys() {
        Set<String> names = new LinkedHashSet<>();
        if (value instanceof Map<?, ?> map) {
            map.keySet().forEach(k -> names.add((String) k));
        }
        return names;
    }

    private List<?> array(String key) throws IOException {
        Object v = raw(key);
        if (v == null) {
            return List.of();
        }
        if (v instanceof List<?> list) {
            return list;
        }
        throw new IOException(placeOf(key) + ": must be an array");
    }

    /** How many items the array at a key has; 0 if there is none. */
    int size(String key) throws IOException {
        return array(key).size();
    }

    /** An object of the array at a key. */
    GltfElement item(String key, int index) throws IOException {
        List<?> list = array(key);
        String where = placeOf(key) + "/" + index;
        if (index < 0 || index >= list.size()) {
            throw new IOException(where + ": there is none: " + placeOf(key) + " has " + list.size());
        }
        if (!(list.get(index) instanceof Map)) {
            throw new IOException(where + ": must be an object");
        }
        return new GltfElement(list.get(index), where);
    }

    /** All objects of the array at a key. */
    List<GltfElement> items(String key) throws IOException {
        List<GltfElement> all = new ArrayList<>();
        for (int i = 0; i < size(key); i++) {
            all.add(item(key, i));
        }
        return all;
    }

    /** The text at a key, or another one. */
    String text(String key, String otherwise) throws IOException {
        Object v = raw(key);
        if (v == null || v instanceof String) {
            return v == null ? otherwise : (String) v;
        }
        throw new IOException(placeOf(key) + ": must be a text");
    }

    /** The texts of the array at a key. */
    List<String> texts(String key) throws IOException {
        List<String> all = new ArrayList<>();
        for (Object v : array(key)) {
            if (!(v instanceof String s)) {
                throw new IOException(placeOf(key) + ": must be an array of texts");
            }
            all.add(s);
        }
        return all;
    }

    /** Whether true stands at a key. */
    boolean flag(String key) throws IOException {
        Object v = raw(key);
        if (v == null || v instanceof Boolean) {
            return Boolean.TRUE.equals(v);
        }
        throw new IOException(placeOf(key) + ": must be true or false");
    }

    /** The finite number at a key, or another one. */
    double number(String key, double otherwise) throws IOException {
        Object v = raw(key);
        if (v == null) {
            return otherwise;
        }
        return number(v, placeOf(key));
    }

    private static double number(Object v, String where) throws IOException {
        if (v instanceof Double d && Double.isFinite(d)) {
            return d;
        }
        throw new IOException(where + ": must be a finite number");
    }

    /** The numbers of the array at a key, or the others if there is none; as many as these are. */
    double[] numbers(String key, double... otherwise) throws IOException {
        if (!has(key)) {
            return otherwise.clone();
        }
        double[] all = numbers(key);
        if (all.length != otherwise.length) {
            throw new IOException(
                    placeOf(key) + ": must be " + otherwise.length + " numbers, not " + all.length + " values");
        }
        return all;
    }

    private double[] numbers(String key) throws IOException {
        List<?> list = array(key);
        double[] all = new double[list.size()];
        for (int i = 0; i < all.length; i++) {
            all[i] = number(list.get(i), placeOf(key) + "/" + i);
        }
        return all;
    }

    /** The whole number at a key, at least 0, or another one. */
    long whole(String key, long otherwise) throws IOException {
        if (!has(key)) {
            return otherwise;
        }
        double v = number(key, 0);
        if (v < 0 || v != StrictMath.rint(v) || v > 1L << 53) {
            throw new IOException(placeOf(key) + ": must be a whole number of at least 0");
        }
        return (long) v;
    }

    /** The whole number at a key, which must be there. */
    long whole(String key) throws IOException {
        if (!has(key)) {
            throw failure("lacks \"" + key + "\"");
        }
        return whole(key, 0);
    }

    /** The index at a key, if there is one: below a count. */
    OptionalInt index(String key, int count) throws IOException {
        if (!has(key)) {
            return OptionalInt.empty();
        }
        long i = whole(key);
        if (i >= count) {
            throw new IOException(placeOf(key) + ": is " + i + ", and there are " + count);
        }
        return OptionalInt.of((int) i);
    }

    /** The indices of the array at a key, each below a count. */
    int[] indices(String key, int count) throws IOException {
        double[] all = numbers(key);
        int[] indices = new int[all.length];
        for (int i = 0; i < all.length; i++) {
            if (all[i] < 0 || all[i] >= count || all[i] != StrictMath.rint(all[i])) {
                throw new IOException(placeOf(key) + "/" + i + ": must be an index below " + count);
            }
            indices[i] = (int) all[i];
        }
        return indices;
    }
}
