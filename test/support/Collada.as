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
