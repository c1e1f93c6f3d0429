package starlogo
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionStatistics;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.fitting.AxisAlignedBoxFitter;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.CentredRitterSphereFitter;
    import starlogo.fitting.CylinderFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.MinimalCapsuleFitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.fitting.RitterSphereFitter;
    import starlogo.fitting.ZAlignedBoxFitter;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.capsuleBox;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereBox;
    import starlogo.intersection.sphereCapsule;
    import starlogo.intersection.sphereSphere;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ObjModel;
    import support.landOf;

    /** The names that the client compiles against, with their types: what does not compile here breaks the client. */
    public class ClientNamesTest
    {
        [Test]
        public function greatLand():void
        {
            var greatLand:GreatLand = new GreatLand();
            var flags:Vector.<Boolean> = new <Boolean>[greatLand.loadTightestFit, greatLand.loadAllBoundingStructures, greatLand.loadHierarchies];
            assertEquals("true,false,true", flags.join());
            var increment:Number = greatLand.orientedBoxDegIncrement;
            assertEquals(10, increment);
            var structures:BoundingStructuresLibrary = greatLand.boundingStructures;
            var hierarchies:HierarchiesLibrary = greatLand.hierarchies;
            greatLand.addModel(new Model("wall", new <Number>[0, 0, 0, 4, 0, 0, 0, 0, 3, 4, 0, 3], new <uint>[0, 1, 2, 1, 3, 2]));
            assertTrue(structures.has("wall") && hierarchies.has("wall"));
        }

        [Test]
        public function models():void
        {
            var all:Vector.<Model> = new <Model>[BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(), new ObjModel("tent", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n", "y")];
            for each (var model:Model in all)
            {
                var name:String = model.name;
                var vertices:Vector.<Number> = model.vertices;
                var triangles:Vector.<uint> = model.triangles;
                assertTrue(name, vertices.length % 3 == 0 && triangles.length % 3 == 0);
            }
            try
            {
                all.push(new ColladaModel("nothing", "<COLLADA/>"));
            }
            catch (error:ModelError)
            {
                assertEquals(4, all.length);
            }
        }

        [Test]
        public function structures():void
        {
            var ball:Sphere = new Sphere(new Vector3D(0, 0, 1), 2);
            var brick:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 2, 3);
            var rod:Capsule = new Capsule(new Vector3D(), new Vector3D(0, 0, 1), 0.5);
            var can:Cylinder = new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 0.5);
            for each (var structure:BoundingStructure in [ball, brick, rod, can])
            {
                var copy:BoundingStructure = structure.clone();
                copy.scale(2);
                copy.rotate(new Matrix3D());
                copy.translate(new Vector3D(1, 2, 3));
                var volume:Number = structure.volume;
                assertTrue(copy.volume > volume && structure.contains(new Vector3D(0, 0, 0.5)));
            }
            assertEquals("3 2 6 0.5", [ball.center.z + ball.radius, brick.halfY, brick.halfX + brick.halfY + brick.halfZ, rod.radius].join(" "));
            assertEquals("0,0,1", [brick.center.x, rod.start.x, can.end.z].join());
            assertEquals(3, brick.axisX.x + brick.axisY.y + brick.axisZ.z);
        }

        [Test]
        public function tests():void
        {
            var ball:Sphere = new Sphere(new Vector3D(), 1);
            var rod:Capsule = new Capsule(new Vector3D(), new Vector3D(1, 0, 0), 1);
            var brick:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
            assertTrue(sphereSphere(ball, ball) && sphereCapsule(ball, rod) && sphereBox(ball, brick));
            assertTrue(capsuleCapsule(rod, rod) && capsuleBox(rod, brick) && boxBox(brick, brick));
            assertTrue(intersects(brick, ball) && intersects(ball, brick));
        }

        [Test]
        public function fitters():void
        {
            var box:Fitter = new OrientedBoxFitter(30);
            var all:Vector.<Fitter> = new <Fitter>[new NaiveSphereFitter(), new RitterSphereFitter(), new AxisAlignedBoxFitter(), new ZAlignedBoxFitter(10), box, new CapsuleFitter(box), new CylinderFitter(box), new CentredRitterSphereFitter(), new MinimalSphereFitter(), new MinimalCapsuleFitter()];
            var vertices:Vector.<Number> = BuiltInModel.cube().vertices;
            for each (var fitter:Fitter in all)
            {
                var structure:BoundingStructure = fitter.fit(vertices);
                assertTrue(structure + " holds the cube's corner", structure.contains(new Vector3D(0.5, 0.5, 1)));
            }
        }

        [Test]
        public function libraries():void
        {
            var structures:BoundingStructuresLibrary = new BoundingStructuresLibrary();
            var fitters:Vector.<Fitter> = structures.fitters;
            assertEquals(3, fitters.length);
            structures.keepAll = true;
            structures.add("cube", BuiltInModel.cube().vertices);
            assertTrue(structures.has("cube"));
            assertTrue(structures.tightestFit("cube") is Box);
            assertTrue(structures.sphere("cube") is Sphere && structures.box("cube") is Box && structures.capsule("cube") is Capsule);

            var hierarchies:HierarchiesLibrary = new HierarchiesLibrary();
            assertEquals("5,10,false", [hierarchies.minVerticesToSplit, hierarchies.maxDepth, hierarchies.splitByMean].join());
            hierarchies.add("points", BuiltInModel.sphere().vertices);
            hierarchies.add("cube", BuiltInModel.cube().vertices, BuiltInModel.cube().triangles);
            assertTrue(hierarchies.has("cube"));
            var root:HierarchyNode = hierarchies.root("points");
            var bounds:BoundingStructure = root.bounds;
            var left:HierarchyNode = root.left;
            var right:HierarchyNode = root.right;
            assertTrue(bounds.volume > 0 && !root.isLeaf);
            assertEquals(root.vertexCount, left.vertexCount + right.vertexCount);
        }

        [Test]
        public function agentsAndCollisions():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            var agent:Agent = new Agent("cube");
            var other:Agent = new Agent("cube", "walls");
            agent.hierarchical = true;
            agent.traversalDepth = 3;
            agent.moveTo(0.5, 0, 0);
            var transform:Matrix3D = agent.transform;
            assertEquals(0.5, transform.position.x);
            var hierarchical:HierarchicalCollider = new HierarchicalCollider(greatLand);
            assertEquals(5, hierarchical.maxDepth);
            var agents:Vector.<Agent> = new <Agent>[agent, other];
            for each (var system:CollisionSystem in [new BinCollider(greatLand), new TightestFitCollider(greatLand), hierarchical, new CombinationCollider(greatLand)])
            {
                assertTrue(system.areColliding(agent, other));
                var pairs:Vector.<Agent> = system.findCollisions(agents);
                assertEquals(2, system.findCollisions(agents, pairs).length);
                var called:Boolean = false;
                var collision:Collision = new Collision(system);
                collision.onCollision("walls", "turtles", function(collider:Agent, collidee:Agent):void
                    {
                        called = collider === other && collidee === agent;
                    });
                collision.update(agents);
                var statistics:CollisionStatistics = collision.statistics;
                assertTrue(called && statistics.collisions == 1 && collision.collisionSystem === system);
            }
            agent.x = 1.01;
            assertFalse(hierarchical.areColliding(agent, other));
        }

        [Test]
        public function motion():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            var agent:Agent = new Agent("cube");
            var agents:Vector.<Agent> = new <Agent>[agent, new Agent("cube", "walls")];
            assertFalse(agent.sweeps);
            agent.sweeps = true;
            agent.jumpTo(-5, 0, 0);
            var collision:Collision = new Collision(new TightestFitCollider(greatLand));
            var calls:Array = [];
            collision.onCollisionStart("turtles", "walls", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    calls.push([contact.time.toFixed(6), contact.point.x.toFixed(6), contact.normal.x, contact.depth.toFixed(6)].join(" "));
                });
            collision.onCollisionEnd("turtles", "walls", function(collider:Agent, collidee:Agent):void
                {
                    calls.push("end");
                });
            for each (var x:Number in [-5, 3, 9])
            {
                agent.moveTo(x, 0, 0);
                collision.update(agents);
            }
            assertEquals("0.500000 -0.500000 -1 0.000000,end", calls.join());
        }
    }
}
