extends RefCounted
## The files in a zip, by its list at the end. Nothing is unpacked to where an entry says that it
## belongs, and of an entry never more bytes than its reader asks for: a zip may be made to do harm.

## More entries than this are not looked at.
const MOST := 20_000

const _END := 0x06054b50
const _END_SIZE := 22
const _ENTRY := 0x02014b50
const _ENTRY_SIZE := 46
const _HEADER_SIZE := 30
const _LONGEST_COMMENT := 65_535
const _LARGEST_LIST := 4_000_000
const _LINK := 0xA000
const _LOCKED := 1
const _UTF8 := 0x800
const _STORED := 0
const _DEFLATED := 8


## What the list says of an entry.
class Entry:
	extends RefCounted
	var method := 0
	var checksum := 0
	var packed_size := 0
	var size := 0
	var offset := 0
	var is_locked := false


## One sentence why it cannot be read; "" if it can.
var problem := ""

var _file: FileAccess
var _entries: Dictionary[String, Entry] = {}


## The zip at [param path].
func _init(path: String) -> void:
	_file = FileAccess.open(path, FileAccess.READ)
	if not _file:
		problem = "The zip cannot be opened: is there a right to read it?"
		return
	var list := _list()
	if not problem:
		_read(list)


## The names of its files, with `/` between folders.
func names() -> PackedStringArray:
	return PackedStringArray(_entries.keys())


## The bytes of a file; of one that is larger than [param most], only that there are more. Sets
## [member problem] where they cannot be read.
func bytes_of(name: String, most: int) -> PackedByteArray:
	problem = ""
	var entry := _entries[name]
	var bytes := PackedByteArray()
	if entry.size > most:
		bytes.resize(most + 1)
		return bytes
	if entry.is_locked:
		problem = "The zip is locked by a password."
		return bytes
	_file.seek(entry.offset)
	var header := _file.get_buffer(_HEADER_SIZE)
	if header.size() == _HEADER_SIZE and entry.packed_size <= 2 * most:
		_file.seek(entry.offset + _HEADER_SIZE + header.decode_u16(26) + header.decode_u16(28))
		bytes = _unpacked(_file.get_buffer(entry.packed_size), entry)
	if bytes.size() != entry.size:
		problem = "The zip is damaged, or packed in a way that is not known here."
	return bytes


# The list of its entries, and before it their number.
func _list() -> PackedByteArray:
	var tail_size := mini(_file.get_length(), _LONGEST_COMMENT + _END_SIZE)
	_file.seek(_file.get_length() - tail_size)
	var tail := _file.get_buffer(tail_size)
	var at := tail_size - _END_SIZE
	while at >= 0 and tail.decode_u32(at) != _END:
		at -= 1
	if at < 0:
		problem = "It is no zip."
		return PackedByteArray()
	var size := tail.decode_u32(at + 12)
	if tail.decode_u16(at + 10) > MOST or size > _LARGEST_LIST:
		problem = "The zip holds more than %d files." % MOST
		return PackedByteArray()
	_file.seek(tail.decode_u32(at + 16))
	return _file.get_buffer(size)


func _read(list: PackedByteArray) -> void:
	var at := 0
	while at + _ENTRY_SIZE <= list.size() and list.decode_u32(at) == _ENTRY:
		var entry := Entry.new()
		entry.is_locked = list.decode_u16(at + 8) & _LOCKED != 0
		entry.method = list.decode_u16(at + 10)
		entry.checksum = list.decode_u32(at + 16)
		entry.packed_size = list.decode_u32(at + 20)
		entry.size = list.decode_u32(at + 24)
		entry.offset = list.decode_u32(at + 42)
		var is_link := (list.decode_u32(at + 38) >> 16) & 0xF000 == _LINK
		var its_name := at + _ENTRY_SIZE
		var behind := its_name + list.decode_u16(at + 28)
		var name := _text_of(list.slice(its_name, behind), list.decode_u16(at + 8) & _UTF8 != 0)
		if not is_link and not name.ends_with("/"):
			_entries[name] = entry
		at = behind + list.decode_u16(at + 30) + list.decode_u16(at + 32)


# As the engine knows only streams with a head, the bytes get that of gzip. It checks the sum, too.
static func _unpacked(packed: PackedByteArray, entry: Entry) -> PackedByteArray:
	if entry.method == _STORED or entry.size == 0:
		return packed
	if entry.method != _DEFLATED:
		return PackedByteArray()
	var stream := PackedByteArray([0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 0xff]) + packed
	var foot := PackedByteArray()
	foot.resize(8)
	foot.encode_u32(0, entry.checksum)
	foot.encode_u32(4, entry.size)
	return (stream + foot).decompress(entry.size, FileAccess.COMPRESSION_GZIP)


# Old zips do not say how a name is written: only its ASCII part matters here.
static func _text_of(bytes: PackedByteArray, is_utf8: bool) -> String:
	var text := bytes.get_string_from_utf8() if is_utf8 else bytes.get_string_from_ascii()
	return text.replace("\\", "/")
