package starlogo.away3d
{
    import away3d.bounds.AxisAlignedBoundingBox;
    import away3d.primitives.data.Segment;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.debug.Wireframes;
    import starlogo.models.BuiltInModel;
    import support.SurfaceDistance;
    import support.assertThrows;
    import support.create;

    /** Wireframes among what the real Away3D draws. */
    public class Away3dWireframeTest
    {
        private var _greatLand:GreatLand = new GreatLand();
        private var _agent:Agent;

        [Before]
        public function load():void
        {
            _greatLand.loadAllBoundingStructures = true;
            _greatLand.addModel(BuiltInModel.cylinder());
            _agent = new Agent("cylinder");
            _agent.moveTo(10, 20, 3);
            _agent.heading = 30;
            _agent.pitch = 40;
            _agent.roll = 50;
            _agent.size = 2;
        }

        [Test]
        public function endsAreOnTheStructuresInTheWorld():void
        {
            for each (var structure:BoundingStructure in [_greatLand.boundingStructures.sphere("cylinder"), _greatLand.boundingStructures.box("cylinder"),
                        _greatLand.boundingStructures.capsule("cylinder")])
            {
                var wireframe:Away3dWireframe = new Away3dWireframe(_agent);
                wireframe.showStructure(structure);
                assertEquals(Wireframes.ofStructure(structure).length / 6, wireframe.segmentCount);
                assertTrue(wireframe.segmentCount >= 12);
                var placed:BoundingStructure = structure.clone().scale(_agent.size);
                placed.rotate(rotationOf(_agent)).translate(new Vector3D(_agent.x, _agent.y, _agent.z));
                for (var i:int = 0; i < wireframe.segmentCount; i++)
                {
                    var segment:Segment = wireframe.getSegment(i);
                    assertOnSurface(placed, wireframe.transform.transformVector(segment.start));
                    assertOnSurface(placed, wireframe.transform.transformVector(segment.end));
                }
            }
        }

        private static function rotationOf(agent:Agent):*
        {
            var turned:Agent = new Agent("any");
            turned.heading = agent.heading;
            turned.pitch = agent.pitch;
            turned.roll = agent.roll;
            return turned.transform;
        }

        private static function assertOnSurface(structure:BoundingStructure, drawn:Vector3D):void
        {
            var distance:Number = SurfaceDistance.of(structure, new Vector3D(drawn.x, drawn.z, drawn.y));
            assertTrue("an end is " + distance + " off", distance < 1e-5);
        }

        [Test]
        public function itMovesWithTheAgent():void
        {
            var wireframe:Away3dWireframe = new Away3dWireframe(_agent);
            wireframe.showStructure(_greatLand.boundingStructures.tightestFit("cylinder"));
            assertEquals("10,3,20", [wireframe.x, wireframe.y, wireframe.z].join());
            _agent.moveTo(-1, -2, 7);
            _agent.size = 3;
            wireframe.update();
            assertEquals("-1,7,-2", [wireframe.x, wireframe.y, wireframe.z].join());
            assertEquals(3, wireframe.scaleX);
        }

        [Test]
        public function levelsAreShownOneAtATime():void
        {
            var wireframe:Away3dWireframe = new Away3dWireframe(_agent, 0x123456, 3);
            wireframe.showLevel(_greatLand.hierarchies.root("cylinder"), 3);
            assertEquals(4 * 12, wireframe.segmentCount);
            wireframe.showLevel(_greatLand.hierarchies.root("cylinder"), 1);
            assertEquals(12, wireframe.segmentCount);
            var segment:Segment = wireframe.getSegment(0);
            assertEquals(0x123456, segment.startColor);
            assertEquals(0x123456, segment.endColor);
            assertEquals(3, segment.thickness);
            assertThrows(RangeError, /must be 1 \(the root\) or more, not 0/, wireframe.showLevel, _greatLand.hierarchies.root("cylinder"), 0);
            assertThrows(ArgumentError, /structure to draw must not/, wireframe.showStructure, null);
            assertEquals("what was shown stays", 12, wireframe.segmentCount);
        }

        [Test]
        public function itsBoundsHaveAllCorners():void
        {
            var wireframe:Away3dWireframe = new Away3dWireframe(_agent);
            var box:BoundingStructure = _greatLand.boundingStructures.box("cylinder");
            wireframe.showStructure(box);
            assertTrue(wireframe.bounds is AxisAlignedBoundingBox);
            for (var i:int = 0; i < wireframe.segmentCount; i++)
            {
                var end:Vector3D = wireframe.getSegment(i).start;
                assertTrue(end.x >= wireframe.minX && end.y >= wireframe.minY && end.z >= wireframe.minZ);
                assertTrue(end.x <= wireframe.maxX && end.y <= wireframe.maxY && end.z <= wireframe.maxZ);
            }
            assertTrue(wireframe.maxY > 1);
        }

        [Test]
        public function anAgentIsNeeded():void
        {
            assertThrows(ArgumentError, /agent must not be null/, create, Away3dWireframe, null);
        }
    }
}
