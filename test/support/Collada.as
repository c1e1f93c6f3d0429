package support
{
    /** Small COLLADA documents for tests. */
    public final class Collada
    {
        /** What belongs into the asset of a document with z up. */
        public static const Z_UP:String = "<up_axis>Z_UP</up_axis>";

        /** The only input of a primitive. */
        public static const INPUT:String = '<input semantic="VERTEX" source="#v" offset="0"/>';

        /** A document with libraries, and other things after them. */
        public static function document(libraries:String, rest:String = "", asset:String = ""):String
        {
            return '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>' + asset +
                '</asset>' +
                libraries + rest + '</COLLADA>';
        }

        /** A document with libraries and the nodes of a scene, z up. */
        public static function scene(libraries:String, nodes:String):String
        {
            return document(libraries, '<library_visual_scenes><visual_scene id="s">' + nodes +
                    '</visual_scene></library_visual_scenes>' +
                    '<scene><instance_visual_scene url="#s"/></scene>', Z_UP);
        }

        /** A library with a geometry of points (as text) and primitives. */
        public static function geometry(id:String, points:String, primitives:String):String
        {
            var count:int = points.replace(/<[^>]*>/g, "").match(/\S+/g).length;
            return '<library_geometries><geometry id="' + id + '"><mesh><source id="p"><float_array id="f" count="' +
                count + '">' + points +
                '</float_array><technique_common><accessor source="#f" count="' + count / 3 + '" stride="3">' +
                '<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>' +
                '</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>' + primitives +
                '</mesh></geometry></library_geometries>';
        }

        /** A controller with a skin whose points all move with the node "joint", which was bound at the origin. @param shape the bind shape matrix */
        public static function skin(id:String, source:String, points:int, shape:String):String
        {
            var words:String = new Array(points + 1).join("1 ");
            return '<controller id="' + id + '"><skin source="#' + source + '"><bind_shape_matrix>' + shape + '</bind_shape_matrix>' +
                list("joints", "IDREF_array", "joint", 1) + list("binds", "float_array", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", 16) +
                list("weights", "float_array", "1", 1) +
                '<joints><input semantic="JOINT" source="#joints"/><input semantic="INV_BIND_MATRIX" source="#binds"/></joints>' +
                '<vertex_weights count="' + points + '"><input semantic="JOINT" source="#joints" offset="0"/>' +
                '<input semantic="WEIGHT" source="#weights" offset="1"/><vcount>' + words + '</vcount><v>' + words.replace(/1/g, "0 0") +
                '</v></vertex_weights></skin></controller>';
        }

        private static function list(id:String, array:String, words:String, stride:int):String
        {
            var count:int = words.split(" ").length;
            return '<source id="' + id + '"><' + array + ' id="' + id + 'Array" count="' + count + '">' + words + '</' + array + '><technique_common>' +
                '<accessor source="#' + id + 'Array" count="' + count / stride + '" stride="' + stride + '"/></technique_common></source>';
        }

        /** Triangles of these corners. */
        public static function triangles(corners:String):String
        {
            return '<triangles count="' + corners.split(" ").length / 3 + '">' + INPUT + '<p>' + corners +
                '</p></triangles>';
        }

        /** Polygons of so many corners each. */
        public static function polylist(sizes:String, corners:String):String
        {
            return '<polylist count="' + sizes.match(/\S+/g).length + '">' + INPUT + '<vcount>' + sizes +
                '</vcount><p>' + corners +
                '</p></polylist>';
        }
    }
}
