extends RefCounted
## The options of the presets: ALL that Godot 4.6 has, in the order in which its editor writes them.
## Otherwise opening the editor's export window would change the file of presets. An option that the
## lab does not care about is at its default.

const NO_PATCHES: PackedStringArray = []

## What a preset holds between its path and [code]script_export_mode[/code].
const PACKING := {
	"patches": NO_PATCHES,
	"patch_delta_encoding": false,
	"patch_delta_compression_level_zstd": 19,
	"patch_delta_min_reduction": 0.1,
	"patch_delta_include_filters": "*",
	"patch_delta_exclude_filters": "",
	"encryption_include_filters": "",
	"encryption_exclude_filters": "",
	"seed": 0,
	"encrypt_pck": false,
	"encrypt_directory": false,
}

## The options of a platform. Icons are drawings and cards are lossy pictures: nothing is compressed
## for a graphics card. The scripts for a remote computer are empty, because nothing is sent there.
const OF_PLATFORM: Dictionary[String, Dictionary] = {
	"linux":
	{
		"custom_template/debug": "",
		"custom_template/release": "",
		"debug/export_console_wrapper": 1,
		"binary_format/embed_pck": false,
		"texture_format/s3tc_bptc": true,
		"texture_format/etc2_astc": false,
		"shader_baker/enabled": false,
		"binary_format/architecture": "x86_64",
		"ssh_remote_deploy/enabled": false,
		"ssh_remote_deploy/host": "",
		"ssh_remote_deploy/port": "22",
		"ssh_remote_deploy/extra_args_ssh": "",
		"ssh_remote_deploy/extra_args_scp": "",
		"ssh_remote_deploy/run_script": "",
		"ssh_remote_deploy/cleanup_script": "",
	},
	"web":
	{
		"custom_template/debug": "",
		"custom_template/release": "",
		"variant/extensions_support": false,
		"variant/thread_support": false,
		"vram_texture_compression/for_desktop": true,
		"vram_texture_compression/for_mobile": false,
		"html/export_icon": false,
		"html/custom_html_shell": "res://tools/web/demo_page.html",
		"html/head_include": "",
		"html/canvas_resize_policy": 2,
		"html/focus_canvas_on_start": true,
		"html/experimental_virtual_keyboard": true,
		"progressive_web_app/enabled": false,
		"progressive_web_app/ensure_cross_origin_isolation_headers": true,
		"progressive_web_app/offline_page": "",
		"progressive_web_app/display": 1,
		"progressive_web_app/orientation": 0,
		"progressive_web_app/icon_144x144": "",
		"progressive_web_app/icon_180x180": "",
		"progressive_web_app/icon_512x512": "",
		"progressive_web_app/background_color": Color(0, 0, 0, 1),
		"threads/emscripten_pool_size": 8,
		"threads/godot_pool_size": 4,
	},
}
