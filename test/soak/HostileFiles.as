package soak
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import support.Collada;

    /** Model files that are made to cost time or memory, of about any size. */
    public final class HostileFiles
    {
        private static const POINTS:String = "0 0 0 1 0 0 1 1 0";
        private static const TRIANGLE:String = Collada.triangles("0 1 2");
        private static const INSTANCE:String = '<instance_geometry url="#a"/>';

        /** The names of all of them. */
        public static function get names():Array
        {
            return ["OBJ: a word of zeros", "OBJ: words of zeros", "OBJ: commas", "OBJ: old Mac lines", "OBJ: small faces", "STL: a word of zeros",
                    "STL: old Mac lines", "STL: a count", "COLLADA: a word of zeros", "OBJ: one line", "OBJ: continued lines", "OBJ: one number", "OBJ: one face, zigzag", "OBJ: faces, zigzag", "OBJ: groups",
                    "OBJ: empty lines", "OBJ: spaces", "UTF-16",
                    "XML: small elements", "XML: siblings", "XML: deep", "XML: attributes", "XML: entities", "XML: laughs", "XML: comments",
                    "XML: broken at the end",
                    "COLLADA: zigzags in many meshes", "COLLADA: a polygon with many holes", "COLLADA: a long hole after others", "COLLADA: many lists of corners",
                    "COLLADA: many primitives", "COLLADA: many meshes of one source", "COLLADA: many libraries", "COLLADA: an error among siblings",
                    "COLLADA: transforms placed again", "COLLADA: instances placed again", "COLLADA: controllers",
                    "COLLADA: deep nodes", "COLLADA: long numbers", "COLLADA: counts"].concat(HostileGltf.names);
        }

        /** The bytes or characters of a file. */
        public static function lengthOf(name:String, file:Object):int
        {
            return file is ByteArray ? file.length : String(file).length;
        }

        /** Whether the size of a file is only the number that the file declares, or that it repeats: its cost must not grow at all. */
        public static function isDeclared(name:String):Boolean
        {
            return name.indexOf("declared") >= 0;
        }

        /**
         * Makes one.
         *
         * @param name one of names
         * @param size about how many characters
         * @return a String, or a ByteArray
         */
        public static function make(name:String, size:int):Object
        {
            switch (name)
            {
                case "OBJ: a word of zeros":
                    return "v " + times("0", size) + "x 0 0\n";
                case "OBJ: words of zeros":
                    return times("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n#" + times("0", 1000) + "x\n", size / 1040) + "v 0 0 " + times("0", 9000) + "x\n";
                case "OBJ: commas":
                    return "v 0 0 " + times("0,", size / 2) + "\n";
                case "OBJ: old Mac lines":
                    return times("v 0 0 0\rv 1 0 0\rv 0 1 0\rf -1 -2 -3\r", size / 35);
                case "OBJ: small faces":
                    return "v 0 0 0\nv 1 0 0\n" + times("f 1 2\n", size / 6);
                case "STL: a word of zeros":
                    return "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 " + times("0", size) + "x\n";
                case "STL: old Mac lines":
                    return "solid a\r" + times("facet normal 0 0 1\router loop\rvertex 0 0 0\rvertex 1 0 0\rvertex 0 1 0\rendloop\rendfacet\r",
                            size / 92) + "endsolid\r";
                case "STL: a count":
                    return stl(size);
                case "COLLADA: a word of zeros":
                    return Collada.document(Collada.geometry("a", "0 0 " + times("0", size) + "x", TRIANGLE));
                case "OBJ: one line":
                    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nf " + times("1 2 3 ", size / 6) + "\n";
                case "OBJ: continued lines":
                    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nf " + times("1 2 3 \\\n", size / 8) + "\n";
                case "OBJ: one number":
                    return "v " + times("7", size) + " 0 0\n";
                case "OBJ: one face, zigzag":
                    return zigzagObj(size / 26, 1);
                case "OBJ: faces, zigzag":
                    return zigzagObj(1000, size / 6000);
                case "OBJ: groups":
                    return times("v 0 0 0\ng a\n", size / 12);
                case "OBJ: empty lines":
                    return "v 0 0 0\n" + times("\n", size);
                case "OBJ: spaces":
                    return "v 0 0 0" + times(" ", size) + "\n";
                case "UTF-16":
                    return wide(times("v 0 0 0\n", size / 16));
                case "XML: small elements":
                    return Collada.document(times("<a/>", size / 4));
                case "XML: siblings":
                    return Collada.scene(Collada.geometry("a", POINTS, TRIANGLE), times("<node/>", size / 7));
                case "XML: deep":
                    return "<COLLADA>" + times("<a>", size / 7) + times("</a>", size / 7) + "</COLLADA>";
                case "XML: attributes":
                    return "<COLLADA " + numbered('a# = "" ', size / 12) + "/>";
                case "XML: entities":
                    return "<COLLADA>" + times("&amp;", size / 5) + "</COLLADA>";
                case "XML: laughs":
                    return laughs(size);
                case "XML: comments":
                    return Collada.document(Collada.geometry("a", times("0 0 0<!-- --> ", size / 14), TRIANGLE));
                case "XML: broken at the end":
                    return Collada.document(times("<a/>", size / 4)) + "<";
                case "COLLADA: zigzags in many meshes":
                    return zigzagMeshes(size);
                case "COLLADA: a polygon with many holes":
                    return holes(size, 0);
                case "COLLADA: a long hole after others":
                    return holes(70 * Math.sqrt(8 * size), size / 5);
                case "COLLADA: many lists of corners":
                    return Collada.document(Collada.geometry("a", POINTS, "<triangles>" + Collada.INPUT + times("<p>0 1 2</p>", size / 12) +
                                "</triangles>"));
                case "COLLADA: many primitives":
                    return Collada.document(Collada.geometry("a", POINTS, times(TRIANGLE, size / TRIANGLE.length)));
                case "COLLADA: many meshes of one source":
                    return meshesOfOneSource(size);
                case "COLLADA: many libraries":
                    return "<COLLADA>" + times('<library_geometries><geometry id="a"/></library_geometries>', size / 58) + "</COLLADA>";
                case "COLLADA: an error among siblings":
                    return Collada.document(Collada.geometry("a", POINTS, times('<triangles count="0"/>', size / 22) +
                                '<triangles count="1">' + Collada.INPUT + "<p>0 1 9</p></triangles>"));
                case "COLLADA: transforms placed again":
                    return placedAgain("", times("<translate>0 0 0</translate>", size / 28));
                case "COLLADA: instances placed again":
                    return placedAgain("<translate>0 0 0</translate>", times(INSTANCE, size / INSTANCE.length));
                case "COLLADA: controllers":
                    return controllers(size);
                case "COLLADA: deep nodes":
                    return Collada.scene(Collada.geometry("a", POINTS, TRIANGLE), times("<node>", size / 13) + times("</node>", size / 13));
                case "COLLADA: long numbers":
                    return Collada.document(Collada.geometry("a", times("0 0 1" + times("0", 10000) + " ", size / 10006), TRIANGLE));
                case "COLLADA: counts":
                    return Collada.document(Collada.geometry("a", times(POINTS + " ", size / 18),
                                '<triangles count="2000000000"><input semantic="VERTEX" source="#v" offset="255"/><p>0 1 2</p></triangles>'));
                default:
                    return HostileGltf.make(name, size);
            }
        }

        private static function times(text:String, count:int):String
        {
            return new Array(Math.max(1, count) + 1).join(text);
        }

        private static function numbered(text:String, count:int):String
        {
            var parts:Array = [];
            for (var i:int = 0; i < count; i++)
            {
                parts.push(text.replace("#", i));
            }
            return parts.join("");
        }

        // The outline of a comb, whose teeth hide each other's corners: most triangles have corners in them.
        private static function zigzag(corners:int, toText:Function):String
        {
            var parts:Array = [];
            for (var i:int = 0; i < corners; i++)
            {
                var angle:Number = 2 * Math.PI * i / corners;
                var radius:Number = (i & 1) == 0 ? 1 : 0.5;
                parts.push(toText((radius * Math.cos(angle)).toFixed(6), (radius * Math.sin(angle)).toFixed(6)));
            }
            return parts.join("");
        }

        private static function zigzagObj(corners:int, faces:int):String
        {
            var text:String = zigzag(corners, function(x:String, y:String):String
                {
                    return "v " + x + " " + y + " 0\n";
                });
            var face:Array = [];
            for (var i:int = 1; i <= corners; i++)
            {
                face.push(i);
            }
            return text + times("f " + face.join(" ") + "\n", faces);
        }

        private static function zigzagMeshes(size:int):String
        {
            var corners:int = 2000;
            var points:String = zigzag(corners, function(x:String, y:String):String
                {
                    return x + " " + y + " 0 ";
                });
            var list:Array = [];
            for (var i:int = 0; i < corners; i++)
            {
                list.push(i);
            }
            var geometry:String = Collada.geometry("a", points, Collada.polylist(String(corners), list.join(" ")));
            return Collada.document(times(geometry, size / geometry.length));
        }

        // Many holes, and beside them a last one, which goes forth and back so often.
        private static function holes(size:int, turns:int):String
        {
            var points:Array = ["-1 -1 0 1e6 -1 0 1e6 1e6 0 -1 1e6 0"];
            var holes:Array = [];
            for (var i:int = 0; i < size / 70; i++)
            {
                points.push(i + " " + i + " 0 " + i + ".5 " + i + " 0 " + i + " " + i + ".5 0");
                holes.push("<h>" + (3 * i + 4) + " " + (3 * i + 5) + " " + (3 * i + 6) + "</h>");
            }
            return Collada.document(Collada.geometry("a", points.join(" "), '<polygons count="1">' + Collada.INPUT + "<ph><p>0 1 2 3</p>" +
                        holes.join("") + (turns > 0 ? "<h>" + times("1 2 ", turns) + "</h>" : "") + "</ph></polygons>"));
        }

        private static function meshesOfOneSource(size:int):String
        {
            var first:String = Collada.geometry("a", times(POINTS + " ", size / 36), TRIANGLE);
            var mesh:String = '<geometry id="g#"><mesh><vertices id="w#"><input semantic="POSITION" source="#p"/></vertices>' +
                '<triangles count="1"><input semantic="VERTEX" source="#w#" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>';
            var meshes:Array = [];
            for (var i:int = 0; i < size / 400; i++)
            {
                meshes.push(mesh.replace("g#", "g" + i).replace("w#", "w" + i).replace("#w#", "#w" + i));
            }
            return Collada.document(first + "<library_geometries>" + meshes.join("") + "</library_geometries>");
        }

        // 32,768 times.
        private static function placedAgain(before:String, content:String):String
        {
            var nodes:String = '<node id="n0">' + before + content + "</node>";
            for (var i:int = 1; i < 16; i++)
            {
                nodes += ('<node id="n' + i + '">' + times('<instance_node url="#n' + (i - 1) + '"/>', 2) + "</node>");
            }
            return Collada.scene('<library_geometries><geometry id="a"/></library_geometries><library_nodes>' + nodes + "</library_nodes>",
                    '<node><instance_node url="#n15"/></node>');
        }

        private static function controllers(size:int):String
        {
            var shape:String = "<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>";
            var chain:Array = [];
            for (var i:int = 0; i < 250; i++)
            {
                chain.push('<controller id="c' + i + '"><skin source="#' + (i == 0 ? "a" : "c" + (i - 1)) + '">' + shape + "</skin></controller>");
            }
            return Collada.scene(Collada.geometry("a", POINTS, TRIANGLE) + "<library_controllers>" + chain.join("") + "</library_controllers>",
                    "<node>" + times('<instance_controller url="#c249"/>', size / 34) + "</node>");
        }

        private static function laughs(size:int):String
        {
            var text:String = '<!DOCTYPE COLLADA [<!ENTITY l0 "lol"><!ENTITY x SYSTEM "file:///etc/passwd">';
            for (var i:int = 1; i < 30; i++)
            {
                text += "<!ENTITY l" + i + ' "' + times("&l" + (i - 1) + ";", 10) + '">';
            }
            return text + "]><COLLADA>" + times("&l29;&x;", size / 8) + "</COLLADA>";
        }

        // A binary file of triangles at one place.
        private static function stl(size:int):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.length = 84 + 50 * int(size / 50);
            bytes.position = 80;
            bytes.writeUnsignedInt(size / 50);
            return bytes;
        }

        private static function wide(text:String):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeByte(0xFF);
            bytes.writeByte(0xFE);
            for (var i:int = 0; i < text.length; i++)
            {
                bytes.writeByte(text.charCodeAt(i));
                bytes.writeByte(0);
            }
            return bytes;
        }
    }
}
