/** Picture files as bytes: decoders and encoders that give the same result on every machine, and know nothing of what the pixels mean. */
package enlightenment.codec;
