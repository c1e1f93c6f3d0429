package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.CookedModel;
    import starlogo.models.GltfModel;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ModelTransform;
    import starlogo.models.ObjModel;
    import support.Collada;
    import support.EachCollider;
    import support.Effort;
    import support.Gltf;
    import support.assertThrows;
    import support.landOf;

    /** What hits tell of triangles: meshes, materials and weights; and where models have these from. */
    public class HitTrianglesTest
    {
        private static const CORNERS:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";

        private var _random:SeededRandom = new SeededRandom(88);

        [Test]
        public function objFilesNameMaterialsAndMeshes():void
        {
            var model:Model = new ObjModel("a", CORNERS + "f 1 2 3\no left wall\nusemtl stone\nf 1 2 3 4\nusemtl glass # not thick\nf 1 3 4\ng right\nf 2 5 6 3\nusemtl stone\nf 2 5 6\nusemtl none\no left wall\nf 1 1 2\n");
            // triangles come first, then those of the polygons
            assertEquals("-1,1,0,2,0,0,1,1", model.materials.join());
            assertEquals("stone,glass,none", model.materialNames.join());
            assertEquals("-1,0,1,0,0,0,1,1", model.meshes.join());
            assertEquals("left wall,right", model.meshNames.join());
            model = new ObjModel("a", CORNERS + "usemtl stone\nusemtl\nf 1 2 3\no\nf 1 2 3\n");
            assertTrue("none", model.materials == null && model.materialNames == null && model.meshes == null && model.meshNames == null);
            assertNull("no triangles", new ObjModel("a", CORNERS + "o a\n").meshes);
        }

        [Test]
        public function mirroredTrianglesKeepTheirs():void
        {
            var text:String = CORNERS + "usemtl a\nf 1 2 3\nusemtl b\nf 2 5 6\nf 2 6 3\n";
            var plain:Model = new ObjModel("a", text, "z", Model.AS_GIVEN);
            var mirror:Model = new ObjModel("a", text, new ModelTransform(null, new Vector3D(-1, 1, 1)), Model.AS_GIVEN);
            assertEquals("0,1,1", plain.materials.join());
            assertEquals("0,1,1", mirror.materials.join());
            assertEquals("0,2,1,1,4,3,1,2,4", mirror.triangles.join());
            var cooked:Model = CookedModel.fromBytes("a", new GreatLand().cook(mirror));
            assertEquals("0,1,1", cooked.materials.join());
            assertEquals(mirror.triangles.join(), cooked.triangles.join());
        }

        [Test]
        public function colladaBindsMaterialsToPlacedMeshes():void
        {
            var first:String = '<triangles count="1" material="s">' + Collada.INPUT + '<p>0 1 2</p></triangles>';
            var second:String = '<polylist count="1" material="t">' + Collada.INPUT + '<vcount>4</vcount><p>0 1 2 3</p></polylist>' + Collada.triangles("0 2 3");
            var materials:String = '<library_materials><material id="m1" name="Red"/><material id="m2"/></library_materials>';
            var binding:String = '<bind_material><technique_common><instance_material symbol="s" target="#m2"/><instance_material symbol="t" target="#m1"/>'
                + '</technique_common></bind_material>';
            var model:Model = new ColladaModel("a", Collada.scene(materials + Collada.geometry("g", "0 0 0 1 0 0 1 1 0 0 1 0", first + second),
                        '<node name="Door"><instance_geometry url="#g"/></node><node id="n2"><scale>-1 1 1</scale><instance_geometry url="#g">' + binding + '</instance_geometry></node>'));
            assertEquals("0,1,1,-1,2,3,3,-1", model.materials.join());
            assertEquals("s,t,m2,Red", model.materialNames.join());
            assertEquals("0,0,0,0,1,1,1,1", model.meshes.join());
            assertEquals("Door,n2", model.meshNames.join());
        }

        [Test]
        public function aSymbolMayEqualTheIdOfAnotherMaterial():void
        {
            var face:String = '<triangles count="1" material="s">' + Collada.INPUT + '<p>0 1 2</p></triangles>';
            var other:String = face.replace('"s"', '"m"');
            var binding:String = '<bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material>';
            var model:Model = new ColladaModel("a", Collada.scene('<library_materials><material id="m" name="Steel"/></library_materials>' +
                        Collada.geometry("g", "0 0 0 1 0 0 1 1 0", face + other),
                        '<node><instance_geometry url="#g">' + binding + '</instance_geometry></node>'));
            assertEquals("0,1", model.materials.join());
            assertEquals("Steel,m", model.materialNames.join());
        }

        [Test]
        public function gltfHasMaterialsOfItsFileAndNodes():void
        {
            var file:Gltf = new Gltf();
            var position:int = file.addNumbers([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], "VEC3", Gltf.FLOAT);
            var fan:Object = {attributes: {POSITION: position}, mode: 6, material: 2};
            file.json.materials = [ {name: "Red"}, {}, {name: "Blue"}];
            file.addMesh({attributes: {POSITION: position}}, fan);
            file.json.meshes[0].name = "Wall";
            file.json.nodes = [ {mesh: 0, name: "Door"}, {mesh: 0, scale: [-1, 1, 1]}];
            var model:Model = GltfModel.fromBytes("a", file.toBinary());
            assertEquals("-1,2,2,-1,2,2", model.materials.join());
            assertEquals(3, model.materialNames.length);
            assertTrue(model.materialNames[0] == "Red" && model.materialNames[1] == null && model.materialNames[2] == "Blue");
            assertEquals("0,0,0,1,1,1", model.meshes.join());
            assertEquals("Door,Wall", model.meshNames.join());
            var cooked:Model = CookedModel.fromBytes("a", new GreatLand().cook(model));
            assertSame(model, cooked);
        }

        [Test]
        public function arraysGetThem():void
        {
            var model:Model = square("a");
            assertNull(model.materials);
            var numbers:Vector.<int> = new <int>[3, -1];
            model.setMaterials(numbers);
            numbers[0] = 9;
            assertEquals("copied", "3,-1", model.materials.join());
            assertNull(model.materialNames);
            model.setMeshes(new <int>[0, 1], new <String>["a", "b"]);
            assertThrows(ModelError, /3 numbers of meshes for 2 triangles/, model.setMeshes, new <int>[0, 1, 0]);
            assertThrows(ModelError, /no name for number 2 of its meshes/, model.setMeshes, new <int>[0, 2], new <String>["a", "b"]);
            assertThrows(ModelError, /a number less than -1: -2 among its materials/, model.setMaterials, new <int>[0, -2]);
            assertEquals("as before", "0,1", model.meshes.join());
            assertSame(model, CookedModel.fromBytes("a", new GreatLand().cook(model)));
            model.setMaterials();
            assertNull(model.materials);
            assertSame(model, CookedModel.fromBytes("a", new GreatLand().cook(model)));
        }

        [Test]
        public function plainModelsHaveCookedFilesAsBefore():void
        {
            var model:Model = BuiltInModel.cube();
            var bytes:ByteArray = new GreatLand().cook(model);
            model.setMaterials(new Vector.<int>(model.triangles.length / 3));
            var longer:ByteArray = new GreatLand().cook(model);
            assertTrue(longer.length + " after " + bytes.length, longer.length > bytes.length && longer.length < bytes.length + 24);
            assertNull(CookedModel.fromBytes("cube", bytes).materials);
        }

        [Test]
        public function raysTellThem():void
        {
            var model:Model = square("square");
            model.setMaterials(new <int>[1, -1], new <String>["wood", "iron"]);
            var agent:Agent = new Agent("square");
            var queries:AgentQueries = queriesOf(model, agent, "triangles");
            var hit:RayHit = queries.cast(new Vector3D(0.25, -0.25, 3), new Vector3D(0, 0, -1));
            assertEquals("0,-1,1,iron", [hit.triangle, hit.mesh, hit.material, hit.materialName].join());
            assertTrue(String(hit.weights), Vector3D.distance(hit.weights, new Vector3D(0.25, 0.5, 0.25)) < 1e-12);
            queries.cast(new Vector3D(-0.25, 0.25, 3), new Vector3D(0, 0, -1), Infinity, null, hit);
            assertTrue("none", hit.triangle == 1 && hit.material == -1 && hit.materialName == null);
            // a model may get them later
            model.setMeshes(new <int>[0, 1], new <String>["left", "right"]);
            queries.cast(new Vector3D(-0.25, 0.25, 3), new Vector3D(0, 0, -1), Infinity, null, hit);
            assertEquals("1,right", [hit.mesh, hit.meshName].join());
            queries = queriesOf(model, agent, "tightest fits");
            queries.cast(new Vector3D(0.25, -0.25, 3), new Vector3D(0, 0, -1), Infinity, null, hit);
            assertTrue("a structure", hit.triangle == -1 && hit.mesh == -1 && hit.meshName == null && hit.material == -1 && hit.materialName == null && hit.weights.length == 0);
        }

        [Test]
        public function howeverNarrowATriangleIsItsWeightsMakeThePoint():void
        {
            var agent:Agent = new Agent("needle");
            for each (var height:Number in [1e-6, 1e-9, 1e-12, 1e-15, 0])
            {
                for (var turn:int = 0; turn < 3; turn++)
                {
                    // the longest edge is each of the three
                    var corners:Array = [new Vector3D(0, 0, 0.3), new Vector3D(1, 0, 0.7), new Vector3D(0.4, height, 0.46)];
                    corners = corners.concat(corners).slice(turn, turn + 3);
                    var vertices:Vector.<Number> = new Vector.<Number>();
                    for each (var corner:Vector3D in corners)
                    {
                        vertices.push(corner.x, corner.y, corner.z);
                    }
                    var needle:Model = new Model("needle", vertices, new <uint>[0, 1, 2], Model.AS_GIVEN);
                    var queries:AgentQueries = queriesOf(needle, agent, "triangles");
                    for each (var along:Number in [0.05, 0.4, 0.43, 0.95])
                    {
                        var at:Vector3D = new Vector3D(along, 0, 0.3 + 0.4 * along);
                        var hit:RayHit = queries.cast(new Vector3D(at.x - 0.3, 0.2, 2), new Vector3D(0.3, -0.2, at.z - 2));
                        checkTriangle(needle, agent, 0, hit.point, hit.weights);
                        var ball:ShapeHit = queries.castShape(new Sphere(new Vector3D(at.x, 0, 3), 0.1), 0, 0, -5);
                        checkTriangle(needle, agent, 0, ball.point, ball.weights);
                    }
                }
            }
            var point:Model = new Model("needle", new <Number>[1, 2, 3, 1, 2, 3, 1, 2, 3], new <uint>[0, 1, 2], Model.AS_GIVEN);
            var inOne:ShapeHit = queriesOf(point, agent, "triangles").castShape(new Sphere(new Vector3D(1, 2, 5), 0.1), 0, 0, -5);
            checkTriangle(point, agent, 0, inOne.point, inOne.weights);
        }

        [Test]
        public function castsTellThem():void
        {
            var model:Model = square("square");
            model.setMaterials(new <int>[1, 0], new <String>["wood", "iron"]);
            var agent:Agent = new Agent("square");
            var ball:Sphere = new Sphere(new Vector3D(0.25, -0.25, 3), 0.1);
            var hit:ShapeHit = queriesOf(model, agent, "triangles").castShape(ball, 0, 0, -5);
            assertEquals("0,-1,1,iron", [hit.triangle, hit.mesh, hit.material, hit.materialName].join());
            assertTrue(String(hit.weights), Vector3D.distance(hit.weights, new Vector3D(0.25, 0.5, 0.25)) < 1e-8);
            ball.center.x = 0.5;
            hit = queriesOf(model, agent, "triangles").castShape(ball, 0, 0, -5, null, hit);
            assertEquals("a corner without a share", 0, Math.min(hit.weights.x, Math.min(hit.weights.y, hit.weights.z)));
            ball.center.x = 0.25;
            hit = queriesOf(model, agent, "hierarchies").castShape(ball, 0, 0, -5, null, hit);
            assertTrue("nodes", hit.triangle == -1 && hit.material == -1 && hit.materialName == null && hit.weights.length == 0);
            hit = queriesOf(model, agent, "bins").castShape(ball, 0, 0, -5, null, hit);
            assertTrue("a sphere", hit.triangle == -1 && hit.material == -1);
        }

        // A soup in which each triangle has a material of its own, cooked and not.
        [Test(timeout="3600000")]
        public function hitsAreOfTheTriangleThatHasThePoint():void
        {
            var count:int = Effort.choose(12, 200);
            var told:int = 0;
            for (var world:int = 0; world < count; world++)
            {
                var model:Model = soup("soup", _random.integer(1, 60));
                var agent:Agent = new Agent("soup");
                agent.size = _random.between(0.5, 3);
                agent.heading = _random.between(-180, 180);
                agent.pitch = _random.between(-90, 90);
                agent.moveTo(_random.between(-50, 50), _random.between(-50, 50), _random.between(-5, 5));
                var queries:AgentQueries = queriesOf(model, agent, "triangles");
                var cooked:AgentQueries = queriesOf(CookedModel.fromBytes("soup", new GreatLand().cook(model)), agent, "triangles");
                for (var i:int = 0; i < 30; i++)
                {
                    var from:Vector3D = new Vector3D(agent.x + _random.between(-4, 4), agent.y + _random.between(-4, 4), agent.z + _random.between(-4, 4));
                    var way:Vector3D = new Vector3D(agent.x + _random.between(-0.5, 0.5), agent.y + _random.between(-0.5, 0.5), agent.z + 0.5 * agent.size).subtract(from);
                    var hits:Vector.<RayHit> = queries.castAll(from, way, Infinity, null, null, true);
                    var others:Vector.<RayHit> = cooked.castAll(from, way, Infinity, null, null, true);
                    assertEquals(hits.length, others.length);
                    for (var k:int = 0; k < hits.length; k++)
                    {
                        checkTriangle(model, agent, hits[k].triangle, hits[k].point, hits[k].weights);
                        checkLabels(model, hits[k].triangle, hits[k].mesh, hits[k].material, hits[k].materialName);
                        checkLabels(model, others[k].triangle, others[k].mesh, others[k].material, others[k].materialName);
                        assertEquals(hits[k].triangle, others[k].triangle);
                        told++;
                    }
                    var ball:Sphere = new Sphere(from, 0.05 * agent.size);
                    var hit:ShapeHit = queries.castShape(ball, way.x, way.y, way.z);
                    if (hit != null && hit.time > 0)
                    {
                        checkTriangle(model, agent, hit.triangle, hit.point, hit.weights);
                        checkLabels(model, hit.triangle, hit.mesh, hit.material, hit.materialName);
                        told++;
                    }
                }
            }
            assertTrue("told " + told, told > 10 * count);
        }

        /** Rounding puts the point a little beside the corner that a ball meets. */
        [Test]
        public function aCornerHasNoMoreThanTheWholeWeight():void
        {
            var told:int = 0;
            for (var world:int = 0; world < 60; world++)
            {
                var model:Model = soup("soup", 1);
                var agent:Agent = new Agent("soup");
                var queries:AgentQueries = queriesOf(model, agent, "triangles");
                for (var i:int = 0; i < 9; i++)
                {
                    var at:int = 3 * model.triangles[i % 3];
                    var corner:Vector3D = agent.transform.transformVector(new Vector3D(model.vertices[at], model.vertices[at + 1], model.vertices[at + 2]));
                    var from:Vector3D = new Vector3D(_random.between(-3, 3), _random.between(-3, 3), _random.between(-3, 3));
                    var way:Vector3D = corner.subtract(from);
                    var hit:ShapeHit = queries.castShape(new Sphere(from, 0.05), way.x, way.y, way.z);
                    if (hit != null && hit.time > 0)
                    {
                        checkTriangle(model, agent, hit.triangle, hit.point, hit.weights);
                        told++;
                    }
                }
            }
            assertTrue("told " + told, told > 200);
        }

        /** Labels number the triangles of the model, not those of a hierarchy that a game has made of other ones. */
        [Test]
        public function otherTrianglesHaveNoLabels():void
        {
            var cube:Model = BuiltInModel.cube();
            cube.setMaterials(new Vector.<int>(12), new <String>["wood"]);
            cube.setMeshes(new Vector.<int>(12), new <String>["crate"]);
            var sphere:Model = BuiltInModel.sphere();
            var few:Vector.<uint> = cube.triangles.slice(6);
            var land:GreatLand = landOf(cube);
            for each (var proxy:Array in [[sphere.vertices, sphere.triangles, -1], [cube.vertices, few, -1], [cube.vertices, cube.triangles, 0]])
            {
                land.hierarchies.add("cube", proxy[0], proxy[1]);
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                collider.exact = true;
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(new <Agent>[new Agent("cube")]);
                var hit:RayHit = null;
                for each (var direction:Vector3D in [new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1)])
                {
                    hit ||= queries.cast(new Vector3D(0.1 - 3 * direction.x, 0.2 - 3 * direction.y, 0.3 - 3 * direction.z), direction);
                }
                assertTrue(hit.triangle >= 0);
                assertEquals(proxy[2], hit.material);
                assertEquals(proxy[2], hit.mesh);
                assertEquals(proxy[2] < 0 ? null : "wood", hit.materialName);
                assertEquals(proxy[2] < 0 ? null : "crate", hit.meshName);
            }
        }

        // The corners of the triangle with the weights make the point.
        private static function checkTriangle(model:Model, agent:Agent, triangle:int, point:Vector3D, weights:Vector3D):void
        {
            var made:Vector3D = new Vector3D();
            var shares:Array = [weights.x, weights.y, weights.z];
            for (var corner:int = 0; corner < 3; corner++)
            {
                var at:int = 3 * model.triangles[3 * triangle + corner];
                var place:Vector3D = agent.transform.transformVector(new Vector3D(model.vertices[at], model.vertices[at + 1], model.vertices[at + 2]));
                place.scaleBy(shares[corner]);
                made.incrementBy(place);
                assertTrue(shares.join(), shares[corner] >= 0 && shares[corner] <= 1);
            }
            // Flash Player's matrices have single precision
            assertTrue(made + ", not " + point, Vector3D.distance(made, point) < 1e-5);
            assertTrue(Math.abs(weights.x + weights.y + weights.z - 1) < 1e-12);
        }

        private static function checkLabels(model:Model, triangle:int, mesh:int, material:int, name:String):void
        {
            // a model none of whose triangles has a number has no list of them
            assertEquals(model.meshes == null ? -1 : model.meshes[triangle], mesh);
            assertEquals(model.materials == null ? -1 : model.materials[triangle], material);
            assertEquals(material < 0 ? null : model.materialNames[material], name);
        }

        private static function assertSame(expected:Model, found:Model):void
        {
            for each (var what:String in ["materials", "materialNames", "meshes", "meshNames"])
            {
                assertEquals(what, textOf(expected[what]), textOf(found[what]));
            }
        }

        private static function textOf(list:Object):String
        {
            return list == null ? "none" : list.length + ": " + list.join();
        }

        private function soup(name:String, count:int):Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            var materials:Vector.<int> = new Vector.<int>();
            var meshes:Vector.<int> = new Vector.<int>();
            var names:Vector.<String> = new Vector.<String>();
            for (var i:int = 0; i < count; i++)
            {
                for (var k:int = 0; k < 9; k++)
                {
                    vertices.push(k < 3 ? _random.between(-1, 1) : vertices[9 * i + k % 3] + _random.between(-0.5, 0.5));
                }
                triangles.push(3 * i, 3 * i + 1, 3 * i + 2);
                materials.push(_random.integer(-1, count - 1));
                meshes.push(_random.integer(-1, 3));
                names.push("m" + i);
            }
            var model:Model = new Model(name, vertices, triangles);
            model.setMaterials(materials, names);
            model.setMeshes(meshes);
            return model;
        }

        // Two triangles at z = 0, with a common edge along x = y. The first has the corner with the greatest x and the least y.
        private static function square(name:String):Model
        {
            return new Model(name, new <Number>[-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0], new <uint>[0, 1, 2, 0, 2, 3]);
        }

        private static function queriesOf(model:Model, agent:Agent, system:String):AgentQueries
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.orientedBoxDegIncrement = 45;
            greatLand.addModel(model);
            var queries:AgentQueries = new AgentQueries(EachCollider.make(system, greatLand));
            queries.update(new <Agent>[agent]);
            return queries;
        }
    }
}
