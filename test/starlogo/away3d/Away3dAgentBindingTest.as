package starlogo.away3d
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Object3D;
    import away3d.entities.Mesh;
    import away3d.primitives.CubeGeometry;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.models.Model;
    import support.assertThrows;

    /** Agents and real objects of Away3D's kept at one place. */
    public class Away3dAgentBindingTest
    {
        // single precision may be what Away3D draws with
        private static const NEAR:Number = 1e-4;
        private static const ANGLES:Array = [0, 90, -90, 180, 270, 360, 89.9999999, 45];

        private var _random:SeededRandom = new SeededRandom(1304);
        private var _agent:Agent = new Agent("cube");
        private var _object:Mesh = new Mesh(new CubeGeometry(1, 1, 1));
        private var _binding:Away3dAgentBinding = new Away3dAgentBinding(_agent, _object);

        [Test]
        public function axesAndTurnsGoOver():void
        {
            _agent.moveTo(1, 2, 3);
            _agent.heading = 30;
            _agent.size = 2;
            _binding.updateObject();
            assertEquals("1,3,2", [_object.x, _object.y, _object.z].join());
            assertAngles(0, -30, 0);
            assertEquals("2,2,2", [_object.scaleX, _object.scaleY, _object.scaleZ].join());
            _agent.heading = 0;
            _agent.pitch = 20;
            _agent.roll = 10;
            _binding.updateObject();
            assertAngles(-10, 0, -20);
        }

        [Test]
        public function aFullTurnStaysOne():void
        {
            _agent.heading = 725;
            _binding.updateObject();
            assertAngles(0, -725, 0);
            _object.rotationY = -730;
            _binding.updateAgent();
            assertNear(730, _agent.heading, 1e-9);
            assertEquals("0,0", [_agent.pitch, _agent.roll].join());
        }

        private function assertAngles(x:Number, y:Number, z:Number):void
        {
            assertNear(x, _object.rotationX, 1e-9);
            assertNear(y, _object.rotationY, 1e-9);
            assertNear(z, _object.rotationZ, 1e-9);
        }

        [Test]
        public function whatIsDrawnIsWhatCollidesWhenTheAgentLeads():void
        {
            var locked:int = 0;
            for (var i:int = 0; i < 200; i++)
            {
                var source:ObjectContainer3D = randomSource();
                var model:Away3dModel = i % 3 == 0 ? null : new Away3dModel("source", source);
                var agent:Agent = new Agent("source");
                var binding:Away3dAgentBinding = new Away3dAgentBinding(agent, source, model);
                for (var change:int = 0; change < 3; change++)
                {
                    place(agent);
                    locked += Math.abs(agent.pitch % 180) == 90 ? 1 : 0;
                    binding.updateObject();
                    assertDrawnWhereItCollides(agent, source, model, "case " + i);
                }
            }
            assertTrue("gimbal lock: " + locked, locked > 30 && locked < 500);
        }

        [Test]
        public function whatIsDrawnIsWhatCollidesWhenTheObjectLeads():void
        {
            var locked:int = 0;
            for (var i:int = 0; i < 200; i++)
            {
                var source:ObjectContainer3D = randomSource();
                var model:Away3dModel = i % 3 == 0 ? null : new Away3dModel("source", source);
                var agent:Agent = new Agent("source");
                var binding:Away3dAgentBinding = new Away3dAgentBinding(agent, source, model);
                for (var change:int = 0; change < 3; change++)
                {
                    source.moveTo(_random.between(-50, 50), _random.between(0, 5), _random.between(-50, 50));
                    source.rotateTo(angle(), angle(), angle());
                    source.scaleX = source.scaleY = source.scaleZ = _random.logBetween(0.1, 10);
                    locked += Math.abs(source.rotationY % 180) == 90 ? 1 : 0;
                    binding.updateAgent();
                    assertDrawnWhereItCollides(agent, source, model, "case " + i);
                }
            }
            assertTrue("gimbal lock: " + locked, locked > 30 && locked < 500);
        }

        [Test]
        public function thereAndBackIsTheSame():void
        {
            for (var i:int = 0; i < 200; i++)
            {
                var source:ObjectContainer3D = randomSource();
                var model:Away3dModel = new Away3dModel("source", source);
                var agent:Agent = new Agent("source");
                place(agent);
                new Away3dAgentBinding(agent, source, model).updateObject();
                var other:Agent = new Agent("source");
                new Away3dAgentBinding(other, source, model).updateAgent();
                var there:Vector.<Number> = agent.transform.rawData;
                var back:Vector.<Number> = other.transform.rawData;
                for (var j:int = 0; j < 16; j++)
                {
                    // doubles throughout, but for what the player's Matrix3D keeps of them
                    assertNear(there[j], back[j], 1e-6 * (1 + Math.abs(there[j])));
                }
                assertNear(agent.x, other.x, 1e-11);
                assertNear(agent.size, other.size, 1e-12 * agent.size);
            }
        }

        private function randomSource():ObjectContainer3D
        {
            var source:ObjectContainer3D = _random.chance() ? new Mesh(new CubeGeometry(1, 2, 3)) : new ObjectContainer3D();
            var child:Mesh = new Mesh(new CubeGeometry(3, 1, 2));
            child.moveTo(_random.between(-4, 4), _random.between(-4, 4), _random.between(-4, 4));
            child.scaleX = _random.pick([1, -1, 2]);
            child.rotationY = _random.between(-90, 90);
            source.addChild(child);
            if (_random.chance(0.7))
            {
                source.pivotPoint = new Vector3D(_random.between(-3, 3), _random.between(-3, 3), _random.between(-3, 3));
            }
            return source;
        }

        private function place(agent:Agent):void
        {
            agent.moveTo(_random.between(-50, 50), _random.between(-50, 50), _random.between(0, 5));
            agent.heading = angle();
            agent.pitch = angle();
            agent.roll = angle();
            agent.size = _random.logBetween(0.1, 10);
        }

        private function angle():Number
        {
            return _random.chance() ? _random.pick(ANGLES) : _random.between(-400, 400);
        }

        // A source's vertices through Away3D's own matrix, against the model's through the agent's.
        private function assertDrawnWhereItCollides(agent:Agent, source:ObjectContainer3D, model:Away3dModel, name:String):void
        {
            var vertices:Vector.<Number> = model == null ? randomPoints() : model.vertices;
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                var collides:Vector3D = agent.transform.transformVector(new Vector3D(vertices[i], vertices[i + 1], vertices[i + 2]));
                var own:Vector3D = new Vector3D(vertices[i], vertices[i + 2], vertices[i + 1]);
                if (model != null)
                {
                    own.scaleBy(model.width);
                    own.incrementBy(model.origin);
                }
                var drawn:Vector3D = source.transform.transformVector(own);
                var gap:Number = Math.abs(drawn.x - collides.x) + Math.abs(drawn.z - collides.y) + Math.abs(drawn.y - collides.z);
                assertTrue(name + ": drawn " + gap + " away", gap < NEAR);
            }
        }

        private function randomPoints():Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 12; i++)
            {
                points.push(_random.between(-1, 1));
            }
            return points;
        }

        [Test]
        public function nothingIsDoneWhenNothingHasChanged():void
        {
            var object:CountedObject = new CountedObject();
            var binding:Away3dAgentBinding = new Away3dAgentBinding(_agent, object);
            _agent.moveTo(1, 2, 3);
            _agent.heading = 33;
            _agent.pitch = 44;
            binding.updateObject();
            assertTrue(object.changes > 0);
            object.changes = object.rotations = 0;
            for (var i:int = 0; i < 10; i++)
            {
                binding.updateObject();
                binding.updateAgent();
            }
            assertEquals(0, object.changes);
            // moved to where it is: Away3D's rotateTo would have the matrix computed again
            _agent.moveTo(1, 2, 3);
            binding.updateObject();
            assertEquals(0, object.rotations);
        }

        [Test]
        public function eitherSideIsPutRight():void
        {
            _agent.moveTo(1, 2, 3);
            _binding.updateObject();
            _object.x = 77;
            _binding.updateObject();
            assertEquals(1, _object.x);
            _object.pivotPoint = new Vector3D(1, 0, 0);
            _agent.heading = 90;
            _binding.updateObject();
            var origin:Vector3D = _object.transform.transformVector(new Vector3D());
            assertNear(1, origin.x, 1e-6);
            assertNear(2, origin.z, 1e-6);
            _object.pivotPoint = new Vector3D(0, 0, 0);
            _binding.updateObject();
            assertEquals(1, _object.x);

            _object.y = 9;
            _binding.updateAgent();
            assertEquals(9, _agent.z);
            _agent.z = 4;
            _binding.updateAgent();
            assertEquals(9, _agent.z);
        }

        [Test]
        public function scalesThatNoAgentHasAreErrors():void
        {
            _agent.moveTo(1, 2, 3);
            _agent.heading = 5;
            _agent.size = 6;
            for each (var scales:Array in [[-1, 1, 1], [1, -1, 1], [1, 1, -1], [-1, -1, -1], [1, 2, 1], [1, 1, 1.001], [0, 0, 0], [NaN, 1, 1], [1, NaN, 1],
                        [1, 1, NaN], [Infinity, Infinity, Infinity]])
            {
                _object.scaleX = scales[0];
                _object.scaleY = scales[1];
                _object.scaleZ = scales[2];
                assertThrows(ArgumentError, /agent \d+ .* can't take the scale of its object: it must be positive, finite and the same in x, y and z, not/, _binding.updateAgent);
                assertUntouched();
            }
            _object.scaleX = _object.scaleY = 1;
            _object.scaleZ = 1.000001;
            _binding.updateAgent();
            assertEquals(1, _agent.size);
        }

        [Test]
        public function placesThatNoAgentHasAreErrors():void
        {
            _agent.moveTo(1, 2, 3);
            _agent.heading = 5;
            _agent.size = 6;
            for each (var trait:String in ["x", "y", "z", "rotationX", "rotationY", "rotationZ"])
            {
                for each (var value:Number in [NaN, Infinity, -Infinity])
                {
                    _object[trait] = value;
                    assertThrows(ArgumentError, /position, rotation and pivot point must be finite/, _binding.updateAgent);
                    assertUntouched();
                    // NaN can't be told from what it was
                    _object[trait] = 0;
                }
            }
            _object.pivotPoint = new Vector3D(NaN, 0, 0);
            assertThrows(ArgumentError, /position, rotation and pivot point must be finite/, _binding.updateAgent);
            _object.pivotPoint = new Vector3D();
            _object.x = 1e121;
            assertThrows(RangeError, /can't be of size 1 at \(1e\+?121, 0, 0\)/, _binding.updateAgent);
            assertUntouched();
            _object.x = 0;
            _object.scaleX = _object.scaleY = _object.scaleZ = 1e-130;
            assertThrows(RangeError, /can't be of size 1e-130/, _binding.updateAgent);
            assertUntouched();
        }

        private function assertUntouched():void
        {
            assertEquals("1,2,3,5,0,0,6", [_agent.x, _agent.y, _agent.z, _agent.heading, _agent.pitch, _agent.roll, _agent.size].join());
        }

        [Test]
        public function bothSidesAreNeeded():void
        {
            assertThrows(ArgumentError, /agent must not be null/, make, null, new Object3D());
            assertThrows(ArgumentError, /object must not be null/, make, _agent, null);
            assertEquals(_agent, _binding.agent);
            assertEquals(_object, _binding.object);
        }

        private static function make(agent:Agent, object:Object3D):Away3dAgentBinding
        {
            return new Away3dAgentBinding(agent, object);
        }

        [Test]
        public function aModelOfItsOwnSizeFits():void
        {
            var source:Mesh = new Mesh(new CubeGeometry(10, 20, 10));
            var model:Model = new Away3dModel("tower", source);
            var agent:Agent = new Agent("tower");
            var binding:Away3dAgentBinding = new Away3dAgentBinding(agent, source, Away3dModel(model));
            binding.updateAgent();
            assertEquals(10, agent.size);
            assertEquals("0,0,-10", [agent.x, agent.y, agent.z].join());
            agent.moveTo(5, 6, 0);
            agent.size = 1;
            binding.updateObject();
            assertEquals("5,1,6,0.1", [source.x, source.y, source.z, source.scaleX].join());
            assertFalse(source.scaleX == 1);
        }

        private static function assertNear(expected:Number, found:Number, tolerance:Number):void
        {
            assertTrue("expected " + expected + " but was " + found, Math.abs(expected - found) <= tolerance);
        }
    }
}

import away3d.core.base.Object3D;

/** Counts what is set. */
class CountedObject extends Object3D
{
    public var changes:int = 0;
    public var rotations:int = 0;

    override public function moveTo(dx:Number, dy:Number, dz:Number):void
    {
        changes++;
        super.moveTo(dx, dy, dz);
    }

    override public function rotateTo(ax:Number, ay:Number, az:Number):void
    {
        changes++;
        rotations++;
        super.rotateTo(ax, ay, az);
    }

    override public function set scaleX(value:Number):void
    {
        changes++;
        super.scaleX = value;
    }
}
