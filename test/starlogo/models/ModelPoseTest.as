package starlogo.models
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.data.areSameNumbers;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.libraries.FitStore;
    import starlogo.solid.ModelTree;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;
    import support.MemoryStorage;
    import support.assertClose;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** What Model.pose() writes, what it refuses, and who is told. */
    public class ModelPoseTest
    {
        private static const CORNERS:Vector.<Number> = new <Number>[1, 1, 5, 5, 1, 5, 1, 3, 5, 1, 1, 8];
        private static const FACES:Vector.<uint> = new <uint>[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];

        [Test]
        public function thePoseHasTheScaleAndOriginOfTheFirstVertices():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var first:Vector.<Number> = model.vertices.slice();
            var own:Vector.<Number> = model.vertices;
            var pose:Vector.<Number> = CORNERS.slice();
            // from (5, 1, 5) to (9, 1, 5), which is twice as far from the middle as it was
            pose[3] = 9;
            model.pose(pose);
            assertStrictlyEquals(own, model.vertices);
            assertEquals(first[3] + 1, model.vertices[3]);
            assertEquals(first[4], model.vertices[4]);
            assertEquals(4, model.source.unit);
            model.pose(CORNERS);
            for (var i:int = 0; i < first.length; i++)
            {
                assertClose(first[i], model.vertices[i], 1e-15);
            }
        }

        [Test]
        public function aTransformTurnsThePoseToo():void
        {
            for each (var scaling:String in [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN])
            {
                var transform:ModelTransform = new ModelTransform(new Vector3D(90, 20, 30), new Vector3D(2, 2, 2), new Vector3D(1, 2, 3));
                var model:Model = new ObjModel("pyramid", "v 1 1 5\nv 5 1 5\nv 1 3 5\nv 1 1 8\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", transform, scaling);
                var first:Vector.<Number> = model.vertices.slice();
                model.pose(CORNERS);
                for (var i:int = 0; i < first.length; i++)
                {
                    assertClose(first[i], model.vertices[i], 1e-14);
                }
            }
        }

        [Test]
        public function theSourceMayBeOfAnySize():void
        {
            // the squares of these are 0 or infinite
            for each (var size:Number in [1e-250, 1e-160, 1e160, 1e250])
            {
                var corners:Vector.<Number> = new Vector.<Number>();
                for each (var number:Number in CORNERS)
                {
                    corners.push(number * size);
                }
                for each (var scaling:String in [Model.FOOTPRINT, Model.VOLUME])
                {
                    var model:Model = new Model("pyramid", corners, FACES, scaling);
                    var first:Vector.<Number> = model.vertices.slice();
                    model.pose(corners);
                    for (var i:int = 0; i < first.length; i++)
                    {
                        assertClose(first[i], model.vertices[i], 1e-14);
                    }
                }
            }
        }

        [Test]
        public function whatIsRefusedChangesNothing():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var land:GreatLand = landOf(model);
            var first:Vector.<Number> = model.vertices.slice();
            var revision:int = land.revisionOf("pyramid");
            var bad:Vector.<Number> = CORNERS.slice();
            bad[10] = NaN;
            var large:Vector.<Number> = CORNERS.slice();
            large[0] = 1e61;
            assertThrows(ArgumentError, /null/, model.pose, null);
            assertThrows(ArgumentError, /"pyramid".*4 vertices.*9 numbers/, model.pose, CORNERS.slice(3));
            assertThrows(ArgumentError, /"pyramid".*4 vertices.*15 numbers/, model.pose, CORNERS.concat(CORNERS.slice(9)));
            assertThrows(ArgumentError, /"pyramid".*y coordinate of vertex 3.*NaN/, model.pose, bad);
            assertThrows(ArgumentError, /^model "[^"]+": coordinates must be at most 1e\+60/, model.pose, large);
            assertTrue(areSameNumbers(first, model.vertices));
            assertEquals(revision, land.revisionOf("pyramid"));
            assertTrue(Box(land.hierarchies.root("pyramid").bounds).halfX < 0.6);
        }

        [Test]
        public function aNodeThatIsKeptHasTheBoxesOfTheNewPose():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var root:HierarchyNode = landOf(model).hierarchies.root("pyramid");
            var pose:Vector.<Number> = CORNERS.slice();
            pose[3] = 9;
            assertTrue(Box(root.bounds).halfX < 0.6);
            model.pose(pose);
            assertClose(1, Box(root.bounds).halfX, 1e-6);
        }

        [Test]
        public function eachLandOfTheModelFollows():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var lands:Array = [landOf(model), landOf(model)];
            var pose:Vector.<Number> = CORNERS.slice();
            pose[3] = 9;
            model.pose(pose);
            for each (var land:GreatLand in lands)
            {
                assertClose(1, Box(land.hierarchies.root("pyramid").bounds).halfX, 1e-6);
                assertEquals("added and posed", 2, land.revisionOf("pyramid"));
            }
            var removed:GreatLand = lands[0];
            removed.removeModel("pyramid");
            var replaced:GreatLand = lands[1];
            replaced.addModel(new Model("pyramid", CORNERS, FACES));
            var revisions:int = removed.revisionOf("pyramid") + replaced.revisionOf("pyramid");
            model.pose(CORNERS);
            assertEquals(revisions, removed.revisionOf("pyramid") + replaced.revisionOf("pyramid"));
            // a model that was posed before it is added, and added again
            model.pose(pose);
            removed.addModel(model);
            removed.addModel(model);
            assertClose(1, Box(removed.hierarchies.root("pyramid").bounds).halfX, 1e-6);
            model.pose(CORNERS);
            assertClose(0.5, Box(removed.hierarchies.root("pyramid").bounds).halfX, 1e-6);
        }

        [Test]
        public function structuresFollowOnRequest():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var land:GreatLand = new GreatLand();
            land.loadHulls = true;
            land.addModel(model);
            var before:Number = land.boundingStructures.tightestFit("pyramid").volume;
            var hull:Number = land.boundingStructures.hull("pyramid").volume;
            var pose:Vector.<Number> = CORNERS.slice();
            pose[3] = 9;
            model.pose(pose);
            assertEquals(before, land.boundingStructures.tightestFit("pyramid").volume);
            land.boundingStructures.add(model.name, model.vertices);
            assertTrue(land.boundingStructures.tightestFit("pyramid").volume > 1.5 * before);
            assertTrue(land.boundingStructures.hull("pyramid").volume > 1.5 * hull);
        }

        /** A hierarchy that a game has made of the model's own vertices. */
        [Test]
        public function aHierarchyOfTheSameVerticesFollows():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var land:GreatLand = landOf(model);
            land.hierarchies.add("pyramid", model.vertices, model.triangles);
            model.pose(moved(CORNERS, 5));
            assertClose(5, Box(land.hierarchies.root("pyramid").bounds).center.x, 1e-6);
            var collider:HierarchicalCollider = new HierarchicalCollider(land);
            var there:Agent = new Agent("pyramid");
            var other:Agent = new Agent("other");
            land.addModel(new Model("other", CORNERS, FACES));
            other.moveTo(5, 0, 0);
            assertTrue(collider.areColliding(there, other));
        }

        [Test]
        public function aHierarchyOfOtherVerticesStays():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var land:GreatLand = landOf(model);
            land.hierarchies.add("pyramid", model.vertices.slice(), model.triangles);
            var tree:ModelTree = land.hierarchies.treeOf("pyramid");
            tree.preparedInterior();
            model.pose(moved(CORNERS, 5));
            assertClose(0, Box(land.hierarchies.root("pyramid").bounds).center.x, 1e-6);
            assertTrue(tree.isExactPrepared);
        }

        /** The sphere that was found before the pose does not enclose the model. */
        [Test]
        public function aHullThatIsFoundLaterIsAroundThePose():void
        {
            for each (var factor:Number in [1, 20])
            {
                var vertices:Vector.<Number> = BuiltInModel.cube().vertices.slice();
                var model:Model = new Model("cube", vertices, BuiltInModel.cube().triangles, Model.AS_GIVEN);
                var land:GreatLand = landOf(model);
                for (var i:int = 0; i < vertices.length; i += 3)
                {
                    vertices[i] *= factor;
                }
                model.pose(vertices);
                var hull:BoundingStructure = land.boundingStructures.findOrFit("cube", BoundingStructure.HULL);
                for (i = 0; i < vertices.length; i += 3)
                {
                    assertTrue(hull.contains(new Vector3D(vertices[i], vertices[i + 1], vertices[i + 2])));
                }
            }
        }

        /** Whenever it is posed while it is added, nothing of a mixture is added or stored. */
        [Test]
        public function aModelIsNotPosedWhileItIsAdded():void
        {
            for (var before:int = 0, hasMore:Boolean = true; hasMore; before++)
            {
                var model:Model = new Model("pyramid", CORNERS, FACES);
                var land:GreatLand = new GreatLand();
                var storage:MemoryStorage = new MemoryStorage();
                land.fitStore = new FitStore(1e6, storage);
                var work:Steps = land.receive(model);
                hasMore = true;
                for (var i:int = 0; i < before && hasMore; i++)
                {
                    hasMore = work.step();
                }
                if (hasMore)
                {
                    var storedCount:int = storage.names.length;
                    model.pose(moved(CORNERS, 5));
                    assertThrows(ArgumentError, /"pyramid".*posed/, finish, work);
                    assertFalse(land.hasModel("pyramid"));
                    assertEquals(storedCount, storage.names.length);
                }
            }
        }

        private static function moved(vertices:Vector.<Number>, x:Number):Vector.<Number>
        {
            // the pyramid is divided by 4
            var all:Vector.<Number> = vertices.slice();
            for (var i:int = 0; i < all.length; i += 3)
            {
                all[i] += 4 * x;
            }
            return all;
        }

        [Test]
        public function removingAnUnknownListenerLeavesTheOthers():void
        {
            var model:Model = new Model("pyramid", CORNERS, FACES);
            var calls:int = 0;
            model.addListener(function():void
                {
                    calls++;
                });
            model.removeListener(function():void
                {
                });
            model.pose(CORNERS);
            assertEquals(1, calls);
        }

        /** A cooked model's stored results are those of its first vertices. */
        [Test]
        public function aPosedModelForgetsItsCookedFile():void
        {
            var kitchen:GreatLand = new GreatLand();
            var cooked:CookedModel = CookedModel.fromBytes("pyramid", kitchen.cook(new Model("pyramid", CORNERS, FACES)));
            var lazily:GreatLand = landOf(cooked);
            var pose:Vector.<Number> = CORNERS.slice();
            pose[3] = 9;
            // the first land has not read the tree yet
            cooked.pose(pose);
            assertNull(cooked.data.cooked);
            var later:GreatLand = landOf(cooked);
            for each (var land:GreatLand in [lazily, later, landOf(CookedModel.fromBytes("pyramid", kitchen.cook(cooked)))])
            {
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                collider.exact = true;
                var inside:Agent = new Agent("pyramid");
                inside.size = 0.01;
                inside.moveTo(0.6, -0.22, 0.03);
                assertClose(1, Box(land.hierarchies.root("pyramid").bounds).halfX, 1e-6);
                assertTrue(collider.areColliding(new Agent("pyramid"), inside));
            }
        }
    }
}
