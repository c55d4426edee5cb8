package enlightenment.mesh;

import java.util.Map;
import java.util.Optional;

/** The types of numbers in PLY files. */
enum PlyType {
    INT8(1),
    UINT8(1),
    INT16(2),
    UINT16(2),
    INT32(4),
    UINT32(4),
    FLOAT32(4),
    FLOAT64(8);

    private static final Map<String, PlyType> BY_NAME = Map.ofEntries(
            Map.entry("char", INT8),
            Map.entry("int8", INT8),
            Map.entry("uchar", UINT8),
            Map.entry("uint8", UINT8),
            Map.entry("short", INT16),
            Map.entry("int16", INT16),
            Map.entry("ushort", UINT16),
            Map.entry("uint16", UINT16),
            Map.entry("int", INT32),
            Map.entry("int32", INT32),
            Map.entry("uint", UINT32),
            Map.entry("uint32", UINT32),
            Map.entry("float", FLOAT32),
            Map.entry("float32", FLOAT32),
            Map.entry("double", FLOAT64),
            Map.entry("float64", FLOAT64));

    /** Bytes of a number in the binary forms. */
    final int size;

    PlyType(int size) {
        this.size = size;
    }

    static Optional<PlyType> named(String name) {
        return Optional.ofNullable(BY_NAME.get(name));
    }

    boolean isInteger() {
        return ordinal() < FLOAT32.ordinal();
    }

    /** Whether each number of the type is a float. */
    boolean isOfFloats() {
        return this != INT32 && this != UINT32 && this != FLOAT64;
    }
}
