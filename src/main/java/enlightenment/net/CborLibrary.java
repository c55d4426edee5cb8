package enlightenment.net;

import enlightenment.machine.OptionalLibrary;

/** Servers and workers speak CBOR; a program that embeds the library has what that takes only if it asked for it. */
final class CborLibrary {
    private CborLibrary() {}

    /** Fails early, and with words, where the library is missing. */
    static void require() {
        OptionalLibrary.require(
                "tools.jackson.dataformat.cbor.CBORFactory",
                "Rendering with servers and workers",
                "tools.jackson.dataformat:jackson-dataformat-cbor");
    }
}
