package enlightenment.store;

import java.util.zip.CRC32C;

/** The checksum of what is stored. */
final class Checksum {
    private Checksum() {}

    /** CRC32C, as a number that is not negative. */
    static long of(byte[] bytes) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, 0, bytes.length);
        return crc.getValue();
    }
}
