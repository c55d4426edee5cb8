package enlightenment.codec;

import java.io.IOException;

/** The codes that chunks of OpenEXR pictures may have: their numbers are the ordinals. */
enum ExrCompression {
    NONE(1),
    RLE(1),
    ZIPS(1),
    ZIP(16),
    PIZ(32),
    PXR24(16),
    B44(0),
    B44A(0),
    DWAA(0),
    DWAB(0);

    private static final String READ = "NONE, RLE, ZIPS, ZIP, PIZ and PXR24";

    /** The number of rows in a chunk; 0 if the code is not read. */
    final int rows;

    ExrCompression(int rows) {
        this.rows = rows;
    }

    /** @throws IOException that names the code if it is not read */
    static ExrCompression of(int number) throws IOException {
        if (number < 0 || number >= values().length || values()[number].rows == 0) {
            String name = number >= 0 && number < values().length ? values()[number].name() : "number " + number;
            throw new IOException("compression " + name + " cannot be read, only " + READ);
        }
        return values()[number];
    }

    /**
     * Makes what unpacks chunks of this code.
     *
     * @param types the kinds of the picture's channels, in their order
     * @param width of a row, in pixels
     */
    ExrUnpacker unpacker(ExrType[] types, int width) {
        return switch (this) {
            case RLE -> new ExrRunsUnpacker();
            case ZIPS, ZIP -> new ExrZipUnpacker();
            case PIZ -> new PizUnpacker(types, width);
            case PXR24 -> new Pxr24Unpacker(types, width);
            default ->
                (packed, size) -> {
                    throw new IOException("it has " + packed.remaining() + " bytes instead of " + size);
                };
        };
    }
}
