package enlightenment.codec;

/** The kinds of numbers that channels of OpenEXR pictures hold; in files they are the ordinals. */
enum ExrType {
    UINT(4),
    HALF(2),
    FLOAT(4);

    /** The size of a number, a multiple of 2. */
    final int bytes;

    ExrType(int bytes) {
        this.bytes = bytes;
    }
}
