package enlightenment.mesh;

import enlightenment.mesh.input.BinaryInput;
import enlightenment.mesh.input.TextInput;
import java.io.IOException;
import java.util.function.Supplier;

/** The numbers behind the header of a PLY file. */
interface PlyBody {
    /** The next number, as its type has it. */
    double number(PlyType type) throws IOException;

    /** The next number, which is an integer. */
    long integer(PlyType type) throws IOException;

    /** Passes over numbers. */
    void skip(PlyType type, long count) throws IOException;

    /** The fewest bytes that a number can take, with what separates it from the next. */
    int leastBytes(PlyType type);

    /** The bytes that can still come, at most. */
    long left();

    /** A failure whose message names the place. */
    IOException failure(String what);

    /** Numbers in binary form. */
    static PlyBody binary(BinaryInput in) {
        return new Binary(in);
    }

    /**
     * Numbers in decimal form.
     *
     * @param size the bytes of all of them
     * @param place for messages: which element is read
     */
    static PlyBody ascii(TextInput in, long size, Supplier<String> place) {
        return new Ascii(in, size, place);
    }

    /** Fixed sizes and one order of bytes. */
    record Binary(BinaryInput in) implements PlyBody {
        @Override
        public double number(PlyType type) throws IOException {
            return switch (type) {
                case FLOAT32 -> in.float32();
                case FLOAT64 -> in.float64();
                default -> integer(type);
            };
        }

        @Override
        public long integer(PlyType type) throws IOException {
            return switch (type) {
                case INT8 -> (byte) in.uint8();
                case UINT8 -> in.uint8();
                case INT16 -> in.int16();
                case UINT16 -> in.int16() & 0xffff;
                case INT32 -> in.int32();
                case UINT32 -> in.int32() & 0xffffffffL;
                default -> throw in.failure("has a list of numbers that are no integers");
            };
        }

        @Override
        public void skip(PlyType type, long count) throws IOException {
            in.skip(count * type.size);
        }

        @Override
        public int leastBytes(PlyType type) {
            return type.size;
        }

        @Override
        public long left() {
            return in.left();
        }

        @Override
        public IOException failure(String what) {
            return in.failure(what);
        }
    }

    /** Words between blanks and line ends. */
    record Ascii(TextInput in, long size, Supplier<String> place) implements PlyBody {
        @Override
        public double number(PlyType type) throws IOException {
            in.space();
            return type == PlyType.FLOAT32 ? in.floatNumber() : in.number();
        }

        @Override
        public long integer(PlyType type) throws IOException {
            in.space();
            long n = in.integer();
            in.endWord();
            return n;
        }

        @Override
        public void skip(PlyType type, long count) throws IOException {
            for (long i = 0; i < count; i++) {
                in.space();
                in.number();
            }
        }

        @Override
        public int leastBytes(PlyType type) {
            return 2;
        }

        /** The last number needs nothing behind it. */
        @Override
        public long left() {
            return size + 1 - in.passed();
        }

        @Override
        public IOException failure(String what) {
            return in.failure(place.get() + " " + what);
        }
    }
}
