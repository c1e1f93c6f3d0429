package starlogo.models
{
    import flash.utils.ByteArray;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import support.Fixtures;
    import support.Surfaces;

    /**
     * Models from elsewhere, those of Debian's package assimp-testmodels, against what assimp and trimesh read
     * from them (test/oracle/model_files.py).
     */
    public class ModelFilesTest
    {
        public static const FIXTURES:Array = ["/fixtures/models/expected.json", "/fixtures/models/scenes.json"].concat(addresses());

        private static const FOLDER:String = "/assimp/";
        private static const TOLERANCE:Number = 2e-4;

        private static function addresses():Array
        {
            return [
                    "/assimp/Collada/AsXML.xml",
                    "/assimp/Collada/COLLADA.dae",
                    "/assimp/Collada/COLLADA_triangulate.dae",
                    "/assimp/Collada/Cinema4D.dae",
                    "/assimp/Collada/ConcavePolygon.dae",
                    "/assimp/Collada/anims_with_full_rotations_between_keys.DAE",
                    "/assimp/Collada/box_nested_animation.dae",
                    "/assimp/Collada/cameras.dae",
                    "/assimp/Collada/cube_UTF16LE.dae",
                    "/assimp/Collada/cube_UTF8BOM.dae",
                    "/assimp/Collada/cube_emptyTags.dae",
                    "/assimp/Collada/cube_triangulate.dae",
                    "/assimp/Collada/cube_tristrips.dae",
                    "/assimp/Collada/cube_with_2UVs.DAE",
                    "/assimp/Collada/cube_xmlspecialchars.dae",
                    "/assimp/Collada/duck.dae",
                    "/assimp/Collada/duck_triangulate.dae",
                    "/assimp/Collada/earthCylindrical.DAE",
                    "/assimp/Collada/kwxport_test_vcolors.dae",
                    "/assimp/Collada/library_animation_clips.dae",
                    "/assimp/Collada/lights.dae",
                    "/assimp/Collada/regr01.dae",
                    "/assimp/Collada/sphere.dae",
                    "/assimp/Collada/sphere_triangulate.dae",
                    "/assimp/Collada/teapot_instancenodes.DAE",
                    "/assimp/Collada/teapots.DAE",
                    "/assimp/OBJ/WusonOBJ.obj",
                    "/assimp/OBJ/box.obj",
                    "/assimp/OBJ/box_UTF16BE.obj",
                    "/assimp/OBJ/box_longline.obj",
                    "/assimp/OBJ/box_mat_with_spaces.obj",
                    "/assimp/OBJ/box_without_lineending.obj",
                    "/assimp/OBJ/concave_polygon.obj",
                    "/assimp/OBJ/cube_mtllib_after_g.obj",
                    "/assimp/OBJ/cube_usemtl.obj",
                    "/assimp/OBJ/cube_with_vertexcolors.obj",
                    "/assimp/OBJ/cube_with_vertexcolors_uni.obj",
                    "/assimp/OBJ/empty_mat.obj",
                    "/assimp/OBJ/multiple_spaces.obj",
                    "/assimp/OBJ/number_formats.obj",
                    "/assimp/OBJ/point_cloud.obj",
                    "/assimp/OBJ/regr01.obj",
                    "/assimp/OBJ/regr_3429812.obj",
                    "/assimp/OBJ/space_in_material_name.obj",
                    "/assimp/OBJ/spider.obj",
                    "/assimp/OBJ/testline.obj",
                    "/assimp/OBJ/testmixed.obj",
                    "/assimp/OBJ/testpoints.obj",
                    "/assimp/invalid/empty.obj",
                    "/assimp/invalid/malformed.obj",
                    "/assimp/invalid/malformed2.obj"];
        }

        [Test]
        public function randomScenes():void
        {
            var wrong:Array = [];
            for each (var entry:Object in JSON.parse(Fixtures.text("/fixtures/models/scenes.json")))
            {
                compareModel(new ColladaModel(entry.file, entry.document), entry, wrong);
            }
            assertEquals(wrong.join("\n"), 0, wrong.length);
        }

        [Test]
        public function objFiles():void
        {
            compareAll("OBJ/");
        }

        [Test]
        public function malformedFiles():void
        {
            compareAll("invalid/");
        }

        [Test]
        public function colladaFiles():void
        {
            compareAll("Collada/");
        }

        private static function compareAll(folder:String):void
        {
            Fixtures.assume("/assimp/OBJ/spider.obj", "the package assimp-testmodels is not installed");
            var expected:Array = JSON.parse(Fixtures.text("/fixtures/models/expected.json")) as Array;
            var wrong:Array = [];
            for each (var entry:Object in expected)
            {
                if (entry.file.indexOf(folder) == 0)
                {
                    compare(entry, wrong);
                }
            }
            assertEquals(wrong.join("\n"), 0, wrong.length);
        }

        private static function compare(entry:Object, wrong:Array):void
        {
            var start:int = getTimer();
            var found:Object = read(entry.file);
            var ms:int = getTimer() - start;
            if (entry.hasOwnProperty("fails") != found is ModelError)
            {
                wrong.push(entry.file + ": " + found);
            }
            if (found is ModelError)
            {
                trace("  " + entry.file + ": " + ModelError(found).message +
                        (entry.hasOwnProperty("fails") ? " (it " + entry.fails + ")" : ""));
                return;
            }
            var model:Model = Model(found);
            trace("  " + entry.file + ": " + model.vertices.length / 3 + " vertices, " + triangleCount(model) +
                    " triangles, " +
                    extentsOf(model).map(rounded).join(" x ") + ", " + ms + " ms" + (entry.hasOwnProperty("note") ? " (" +
                        entry.note + ")" : ""));
            if (entry.hasOwnProperty("by"))
            {
                compareModel(model, entry, wrong);
            }
        }

        private static function compareModel(model:Model, entry:Object, wrong:Array):void
        {
            var area:Number = model.triangles == null ? 0 : Surfaces.area(model.vertices, model.triangles);
            var centroid:Array = area == 0 ? [0, 0, 0] : Surfaces.centroid(model.vertices, model.triangles);
            if (distance(extentsOf(model), entry.extents) > TOLERANCE)
            {
                wrong.push(entry.file + ": extents " + extentsOf(model) + ", not " + entry.extents);
            }
            if (Math.abs(area - entry.area) > TOLERANCE * Math.max(1, area))
            {
                wrong.push(entry.file + ": area " + area + ", not " + entry.area);
            }
            if (distance(centroid, entry.centroid) > TOLERANCE)
            {
                wrong.push(entry.file + ": centroid " + centroid + ", not " + entry.centroid);
            }
            if (triangleCount(model) != entry.triangles)
            {
                wrong.push(entry.file + ": " + triangleCount(model) + " triangles, not " + entry.triangles);
            }
            // rounded positions may fall to either side
            if (Math.abs(positionCount(model) - entry.positions) > 0.01 * entry.positions)
            {
                wrong.push(entry.file + ": " + positionCount(model) + " positions, not " + entry.positions);
            }
        }

        private static function extentsOf(model:Model):Array
        {
            var bounds:Vector.<Number> = Surfaces.bounds(model.vertices);
            return [bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5]];
        }

        private static function distance(a:Array, b:Array):Number
        {
            return Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]), Math.abs(a[2] - b[2]));
        }

        private static function triangleCount(model:Model):int
        {
            return model.triangles == null ? 0 : model.triangles.length / 3;
        }

        private static function positionCount(model:Model):int
        {
            var seen:Object = {};
            var count:int = 0;
            for (var i:int = 0; i < model.vertices.length; i += 3)
            {
                var key:String = Math.round(model.vertices[i] * 1e5) + "," + Math.round(model.vertices[i +
                            1] * 1e5) + "," +
                    Math.round(model.vertices[i + 2] * 1e5);
                if (!seen.hasOwnProperty(key))
                {
                    seen[key] = true;
                    count++;
                }
            }
            return count;
        }

        /** The model in a file, or its ModelError. */
        private static function read(file:String):Object
        {
            var bytes:ByteArray = Fixtures.bytes(FOLDER + file);
            try
            {
                return file.substr(-4) == ".obj" ? ObjModel.fromBytes(file, bytes) : ColladaModel.fromBytes(file, bytes);
            }
            catch (error:ModelError)
            {
                return error;
            }
            return null;
        }

        private static function rounded(number:Number, index:int, all:Array):String
        {
            return number.toFixed(3);
        }
    }
}
