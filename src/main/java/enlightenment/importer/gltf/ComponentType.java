package enlightenment.importer.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;

/** How the numbers of an accessor are stored (glTF 2.0, 3.6.2.2). */
enum ComponentType {
    BYTE(5120, 1, 127),
    UNSIGNED_BYTE(5121, 1, 255),
    SHORT(5122, 2, 32767),
    UNSIGNED_SHORT(5123, 2, 65535),
    UNSIGNED_INT(5125, 4, 4294967295.0),
    FLOAT(5126, 4, 1);

    private final int code;
    private final int bytes;

    /** What stands for 1 where numbers are normalized. */
    private final double one;

    ComponentType(int code, int bytes, double one) {
        this.code = code;
        this.bytes = bytes;
        this.one = one;
    }

    static ComponentType of(GltfElement accessor) throws IOException {
        long code = accessor.whole("componentType");
        for (ComponentType type : values()) {
            if (type.code == code) {
                return type;
            }
        }
        throw accessor.failure("has the componentType " + code + ", which glTF 2.0 does not have");
    }

    /** Bytes of a number. */
    int bytes() {
        return bytes;
    }

    /** Whether it holds unsigned whole numbers, as indices are. */
    boolean isIndex() {
        return this == UNSIGNED_BYTE || this == UNSIGNED_SHORT || this == UNSIGNED_INT;
    }

    /** An unsigned whole number; negative beyond the range of int. */
    int whole(ByteBuffer from, int at) {
        return switch (this) {
            case UNSIGNED_BYTE -> from.get(at) & 0xff;
            case UNSIGNED_SHORT -> from.getShort(at) & 0xffff;
            case UNSIGNED_INT -> from.getInt(at);
            default -> throw new IllegalStateException(name());
        };
    }

    /**
     * A number as a float.
     *
     * @param normalized whether whole numbers are fractions of the largest one, those below -1 being -1
     */
    float number(ByteBuffer from, int at, boolean normalized) {
        double v =
                switch (this) {
                    case BYTE -> from.get(at);
                    case UNSIGNED_BYTE -> from.get(at) & 0xff;
                    case SHORT -> from.getShort(at);
                    case UNSIGNED_SHORT -> from.getShort(at) & 0xffff;
                    case UNSIGNED_INT -> Integer.toUnsignedLong(from.getInt(at));
                    case FLOAT -> from.getFloat(at);
                };
        return normalized && this != FLOAT ? (float) Math.max(v / one, -1) : (float) v;
    }
}
